/** Of a material's covered texels that several triangles claim: below it, what they share is the width of a line between two parts. */
export const SHARED_TEXELS = 0.01;
