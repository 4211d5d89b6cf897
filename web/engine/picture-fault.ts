/** What the readers of the picture formats find in a header. */
export interface RawHeader {
  readonly width: number;
  readonly height: number;
  /** EXIF, 1 to 8: 1 is upright. Width and height are as stored, before any turn. */
  readonly orientation: number;
}

/** What is wrong with a picture, as the end of the sentence "The picture “x.png” cannot be used: …". */
export class PictureFault extends Error {
  readonly reason: string;
  readonly hint: string;

  /** @param reason the error's (`TexelcastErrorDetails`) */
  constructor(reason: string, problem: string, hint = "Save the picture again as PNG, JPEG or WebP.") {
    super(problem);
    this.reason = reason;
    this.hint = hint;
  }
}
