/**
 * Draws the texture view in WebGL 2: the picture over a checkerboard, and lines over it. WebGL and not canvas 2D, for
 * the engine's own mip levels make a picture that is shown small both sharp and calm, dirty rectangles go up as they
 * are, and a hundred thousand lines stay crisp at any zoom for a fraction of a millisecond.
 */
import type { TargetUpdate } from "../engine/engine-api.ts";
import type { CssColor } from "./css-color.ts";
import type { TextureCamera } from "./texture-camera.ts";

/** A picture on the GPU. */
export interface PaintedTexture {
  readonly handle: WebGLTexture;
  readonly width: number;
  readonly height: number;
  readonly levels: number;
  /** The finest level that is drawn. */
  firstLevel: number;
}

/** Lines in texture coordinates on the GPU. */
export interface PaintedLines {
  readonly handle: WebGLBuffer;
  readonly vertices: number;
}

export interface PaintColors {
  readonly checkerA: CssColor;
  readonly checkerB: CssColor;
}

const VERTEX = `#version 300 es
in vec2 uv;
uniform vec2 textureSize_texel, corner_px, view_px;
uniform float scale;
out vec2 at;
void main() {
  at = uv;
  vec2 pixel = corner_px + uv * textureSize_texel * scale;
  gl_Position = vec4(pixel / view_px * vec2(2.0, -2.0) + vec2(-1.0, 1.0), 0.0, 1.0);
}`;

/** Squares of 8 CSS pixels, fixed to the view: they do not swim while the texture is zoomed. */
const PICTURE_FRAGMENT = `#version 300 es
precision highp float;
in vec2 at;
uniform sampler2D picture;
uniform vec4 checkerA, checkerB;
uniform vec2 textureSize_texel;
uniform float pixelRatio, scale;
out vec4 color;
void main() {
  ivec2 square = ivec2(gl_FragCoord.xy / (8.0 * pixelRatio));
  vec3 behind = ((square.x + square.y) & 1) == 0 ? checkerA.rgb : checkerB.rgb;
  vec4 texel = texture(picture, at);
  vec3 seen = mix(behind, texel.rgb, texel.a);
  // Lines between the texels, of one device pixel, once a texel is large enough: dark on light and light on dark.
  vec2 apart = abs(fract(at * textureSize_texel + 0.5) - 0.5) * scale * pixelRatio;
  float line = max(0.0, 1.0 - min(apart.x, apart.y) * 2.0) * smoothstep(8.0, 14.0, scale);
  float light = dot(seen, vec3(0.299, 0.587, 0.114));
  color = vec4(mix(seen, vec3(light > 0.5 ? 0.0 : 1.0), line * 0.16), 1.0);
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 lineColor;
out vec4 color;
void main() { color = vec4(lineColor.rgb * lineColor.a, lineColor.a); }`;

const UV_ATTRIBUTE = 0;

const UNIFORMS = [
  ...(["textureSize_texel", "corner_px", "view_px", "scale", "pixelRatio"] as const),
  ...(["checkerA", "checkerB", "lineColor"] as const),
] as const;
type UniformName = (typeof UNIFORMS)[number];

/** With the places of its uniforms: asked for in each frame they are new objects each time, and the browser looks them up. */
interface Program {
  readonly handle: WebGLProgram;
  readonly at: Readonly<Record<UniformName, WebGLUniformLocation | null>>;
}

export class TexturePainter {
  readonly #gl: WebGL2RenderingContext;
  readonly #picture: Program;
  readonly #line: Program;
  readonly #quad: PaintedLines;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#picture = link(gl, PICTURE_FRAGMENT);
    this.#line = link(gl, LINE_FRAGMENT);
    this.#quad = this.makeLines(new Float32Array([0, 0, 1, 0, 0, 1, 1, 1]));
  }

  /** Storage for a picture of so many levels, transparent until it is filled. */
  makeTexture(width: number, height: number, levels: number): PaintedTexture {
    const gl = this.#gl;
    const handle = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, handle);
    gl.texStorage2D(gl.TEXTURE_2D, levels, gl.RGBA8, width, height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, levels > 1 ? gl.LINEAR_MIPMAP_LINEAR : gl.LINEAR);
    return { handle, width, height, levels, firstLevel: 0 };
  }

  /** A picture that is given once; its mip levels are made on the GPU. */
  makePicture(picture: { width: number; height: number; rgba: Uint8Array }): PaintedTexture {
    const { width, height, rgba } = picture;
    const gl = this.#gl;
    const texture = this.makeTexture(width, height, 1 + Math.floor(Math.log2(Math.max(width, height))));
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    gl.generateMipmap(gl.TEXTURE_2D);
    return texture;
  }

  /** Uploads what changed, from a mip level on. */
  upload(texture: PaintedTexture, update: Pick<TargetUpdate, "rects" | "bytes">, fromLevel: number): void {
    const gl = this.#gl;
    gl.bindTexture(gl.TEXTURE_2D, texture.handle);
    for (const { x, y, width, height, level, byteOffset } of update.rects) {
      if (level >= fromLevel && level < texture.levels) {
        gl.texSubImage2D(
          gl.TEXTURE_2D,
          level,
          x,
          y,
          width,
          height,
          gl.RGBA,
          gl.UNSIGNED_BYTE,
          update.bytes,
          byteOffset,
        );
      }
    }
  }

  /** Makes all smaller levels from the finest one. */
  makeLevels(texture: PaintedTexture): void {
    if (texture.levels > 1) {
      this.drawFrom(texture, 0);
      this.#gl.generateMipmap(this.#gl.TEXTURE_2D);
    }
  }

  /** Says which level is the finest that is drawn; the texture is bound afterwards. */
  drawFrom(texture: PaintedTexture, level: number): void {
    const gl = this.#gl;
    gl.bindTexture(gl.TEXTURE_2D, texture.handle);
    if (texture.firstLevel !== level) {
      texture.firstLevel = level;
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_BASE_LEVEL, level);
    }
  }

  makeLines(uvs: Float32Array): PaintedLines {
    const gl = this.#gl;
    const handle = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, handle);
    gl.bufferData(gl.ARRAY_BUFFER, uvs, gl.STATIC_DRAW);
    return { handle, vertices: uvs.length / 2 };
  }

  freeTexture(texture: PaintedTexture): void {
    this.#gl.deleteTexture(texture.handle);
  }

  freeLines(lines: PaintedLines): void {
    this.#gl.deleteBuffer(lines.handle);
  }

  clear(): void {
    const gl = this.#gl;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }

  drawPicture(texture: PaintedTexture, camera: TextureCamera, colors: PaintColors, pixelRatio: number): void {
    const gl = this.#gl;
    this.#use(this.#picture, texture, camera, pixelRatio);
    gl.bindTexture(gl.TEXTURE_2D, texture.handle);
    gl.uniform4fv(this.#picture.at.checkerA, colors.checkerA);
    gl.uniform4fv(this.#picture.at.checkerB, colors.checkerB);
    gl.uniform1f(this.#picture.at.pixelRatio, pixelRatio);
    gl.disable(gl.BLEND);
    this.#bind(this.#quad);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  /** Lines one device pixel wide, in the texture coordinates of a picture of `texture`'s proportions. */
  drawLines(
    lines: PaintedLines,
    color: CssColor,
    texture: PaintedTexture,
    camera: TextureCamera,
    pixelRatio: number,
  ): void {
    this.#drawPlain(this.#gl.LINES, lines, color, texture, camera, pixelRatio);
  }

  /** Filled triangles, given as `makeLines` takes its ends: three corners each. */
  drawTriangles(
    corners: PaintedLines,
    color: CssColor,
    texture: PaintedTexture,
    camera: TextureCamera,
    pixelRatio: number,
  ): void {
    this.#drawPlain(this.#gl.TRIANGLES, corners, color, texture, camera, pixelRatio);
  }

  #drawPlain(
    kind: GLenum,
    points: PaintedLines,
    color: CssColor,
    texture: PaintedTexture,
    camera: TextureCamera,
    pixelRatio: number,
  ): void {
    const gl = this.#gl;
    this.#use(this.#line, texture, camera, pixelRatio);
    gl.uniform4fv(this.#line.at.lineColor, color);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.#bind(points);
    gl.drawArrays(kind, 0, points.vertices);
  }

  #use({ handle, at }: Program, texture: PaintedTexture, camera: TextureCamera, pixelRatio: number): void {
    const gl = this.#gl;
    gl.useProgram(handle);
    gl.uniform2f(at.textureSize_texel, texture.width, texture.height);
    gl.uniform2f(at.corner_px, camera.x, camera.y);
    gl.uniform2f(at.view_px, gl.drawingBufferWidth / pixelRatio, gl.drawingBufferHeight / pixelRatio);
    gl.uniform1f(at.scale, camera.scale);
  }

  #bind(lines: PaintedLines): void {
    const gl = this.#gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, lines.handle);
    gl.enableVertexAttribArray(UV_ATTRIBUTE);
    gl.vertexAttribPointer(UV_ATTRIBUTE, 2, gl.FLOAT, false, 0, 0);
  }
}

function link(gl: WebGL2RenderingContext, fragment: string): Program {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type) as WebGLShader;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.bindAttribLocation(program, UV_ATTRIBUTE, "uv");
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
    throw new Error(`The texture view's shader does not link: ${gl.getProgramInfoLog(program)}`);
  }
  const places = UNIFORMS.map((name) => [name, gl.getUniformLocation(program, name)] as const);
  return { handle: program, at: Object.fromEntries(places) as Program["at"] };
}
