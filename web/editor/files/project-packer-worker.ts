/** A worker that packs one project into one file: to deflate a large model takes seconds, which the page has not. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { type PackingAnswer, type ProjectToPack, packProject } from "./project-packing.ts";

const port = self as unknown as Pick<Worker, "postMessage"> & {
  onmessage: ((event: MessageEvent<ProjectToPack>) => void) | null;
};

port.onmessage = ({ data }) => {
  const answer = (message: PackingAnswer, transfer: Transferable[] = []): void => port.postMessage(message, transfer);
  try {
    const bytes = packProject(data);
    answer({ bytes }, [bytes.buffer]);
  } catch (thrown) {
    answer({ error: TexelcastError.wrap(thrown, "internal", String(thrown)).toJSON() });
  }
};
