import type {} from "../../../web/element/react.ts";
import type { TexelcastEditor } from "../../../web/element/texelcast-editor.ts";

export const good = (
  <texelcast-editor
    class="editor"
    src="mug.glb"
    mode="shop"
    maxDecals={3}
    min-camera-orbit="auto 30deg"
    beforeAccept={async ({ bytes }) => bytes.length < 1000}
    onchange={({ detail }) => detail.areas.map(({ area }) => area.toFixed(1))}
    onsubmit={({ detail }) => detail.texture.sha256.length}
    ref={(editor: TexelcastEditor | null) => void editor?.exportTexture({ dpi: 300 })}
  />
);

// @ts-expect-error There is no such mode.
export const badMode = <texelcast-editor mode="shopp" />;
// @ts-expect-error What changed is told by "areas".
export const badEvent = <texelcast-editor onchange={({ detail }) => detail.area} />;
