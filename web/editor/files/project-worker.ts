/** A worker that packs or unpacks one project or archive: to deflate or inflate a large model takes seconds, which the page has not. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { unzipFiles } from "./archive-files.ts";
import { type ProjectAnswer, type ProjectWork, packProject, unpackProject } from "./project-packing.ts";

const port = self as unknown as Pick<Worker, "postMessage"> & {
  onmessage: ((event: MessageEvent<ProjectWork>) => void) | null;
};

port.onmessage = ({ data }) => {
  const answer = (message: ProjectAnswer, transfer: Transferable[] = []): void => port.postMessage(message, transfer);
  try {
    if ("pack" in data) {
      const packed = packProject(data.pack);
      answer({ packed }, [packed.buffer]);
    } else if ("unzip" in data) {
      const unzipped = unzipFiles(data.unzip.bytes, data.unzip.path);
      answer(
        { unzipped },
        unzipped.map(({ bytes }) => bytes.buffer),
      );
    } else {
      answer({ unpacked: unpackProject(data.unpack.bytes, data.unpack.fileName) });
    }
  } catch (thrown) {
    answer({ error: TexelcastError.wrap(thrown, "internal", String(thrown)).toJSON() });
  }
};
