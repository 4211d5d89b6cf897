/** What is seen in a view now, as a small picture: how projects are shown in their list. */
import type { Stage } from "./stage.ts";

/** The middle of the view in this size, pixels, as a `data:` URI; null while WebGL is lost or the view is hidden. */
export async function pictureOf(stage: Stage, width: number, height: number): Promise<string | null> {
  const { canvas, renderer } = stage;
  const small = document.createElement("canvas");
  small.width = width;
  small.height = height;
  const context = small.getContext("2d");
  // The canvas may reach beyond the view.
  const { clientWidth, clientHeight } = canvas.parentElement ?? canvas;
  if (renderer.getContext().isContextLost() || context === null || clientWidth * clientHeight === 0) {
    return null;
  }
  // What was drawn before is gone from the canvas; what is drawn now is there until this turn ends.
  stage.draw();
  const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = canvas;
  const scale = Math.max(width / clientWidth, height / clientHeight);
  const left = width / 2 + (offsetLeft - clientWidth / 2) * scale;
  const top = height / 2 + (offsetTop - clientHeight / 2) * scale;
  context.imageSmoothingQuality = "high";
  context.drawImage(canvas, left, top, offsetWidth * scale, offsetHeight * scale);
  // Read back at once, it would hold the page up until the GPU has done all that it was given. The fence that is under way, if
  // there is one, lies before this picture.
  await new Promise<void>((done) => stage.whenGpuDone(() => stage.whenGpuDone(done)));
  // Nor is it packed by this thread, as `toDataURL` would: 80 ms on a slow phone, after each step that was kept.
  const packed = await new Promise<Blob | null>((done) => small.toBlob(done, "image/webp", 0.85));
  return packed && (await dataUriOf(packed));
}

function dataUriOf(file: Blob): Promise<string> {
  const reader = new FileReader();
  return new Promise((resolve, reject) => {
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(file);
  });
}
