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

export class TexturePainter {
  readonly #gl: WebGL2RenderingContext;
  #picture: WebGLProgram;
  #line: WebGLProgram;
  #quad: PaintedLines;

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
    return { handle, width, height, levels };
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

  /** Uploads what changed. An update without the smaller levels has them made on the GPU. */
  upload(texture: PaintedTexture, update: TargetUpdate): void {
    const gl = this.#gl;
    gl.bindTexture(gl.TEXTURE_2D, texture.handle);
    for (const { x, y, width, height, level, byteOffset } of update.rects) {
      if (level < texture.levels) {
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
    if (texture.levels > 1 && update.rects.every((rect) => rect.level === 0)) {
      gl.generateMipmap(gl.TEXTURE_2D);
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
    gl.uniform4fv(this.#at(this.#picture, "checkerA"), colors.checkerA);
    gl.uniform4fv(this.#at(this.#picture, "checkerB"), colors.checkerB);
    gl.uniform1f(this.#at(this.#picture, "pixelRatio"), pixelRatio);
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
    const gl = this.#gl;
    this.#use(this.#line, texture, camera, pixelRatio);
    gl.uniform4fv(this.#at(this.#line, "lineColor"), color);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.#bind(lines);
    gl.drawArrays(gl.LINES, 0, lines.vertices);
  }

  /** Filled triangles, given as `makeLines` takes its ends: three corners each. */
  drawTriangles(
    corners: PaintedLines,
    color: CssColor,
    texture: PaintedTexture,
    camera: TextureCamera,
    pixelRatio: number,
  ): void {
    const gl = this.#gl;
    this.#use(this.#line, texture, camera, pixelRatio);
    gl.uniform4fv(this.#at(this.#line, "lineColor"), color);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.#bind(corners);
    gl.drawArrays(gl.TRIANGLES, 0, corners.vertices);
  }

  #use(program: WebGLProgram, texture: PaintedTexture, camera: TextureCamera, pixelRatio: number): void {
    const gl = this.#gl;
    gl.useProgram(program);
    gl.uniform2f(this.#at(program, "textureSize_texel"), texture.width, texture.height);
    gl.uniform2f(this.#at(program, "corner_px"), camera.x, camera.y);
    gl.uniform2f(this.#at(program, "view_px"), gl.drawingBufferWidth / pixelRatio, gl.drawingBufferHeight / pixelRatio);
    gl.uniform1f(this.#at(program, "scale"), camera.scale);
  }

  #bind(lines: PaintedLines): void {
    const gl = this.#gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, lines.handle);
    gl.enableVertexAttribArray(UV_ATTRIBUTE);
    gl.vertexAttribPointer(UV_ATTRIBUTE, 2, gl.FLOAT, false, 0, 0);
  }

  #at(program: WebGLProgram, name: string): WebGLUniformLocation | null {
    return this.#gl.getUniformLocation(program, name);
  }
}

function link(gl: WebGL2RenderingContext, fragment: string): WebGLProgram {
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
  return program;
}
