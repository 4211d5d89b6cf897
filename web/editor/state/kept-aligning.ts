/** Whether what is dragged comes into line: the user's choice, kept by the browser from visit to visit. */
import { keepChoice, keptChoice } from "../storage/kept-choice.ts";

const KEY = "texelcast.aligns";

/** True where nothing else was chosen. */
export const readAligning = (): boolean => keptChoice(KEY) !== "no";

export const keepAligning = (aligns: boolean): void => keepChoice(KEY, aligns ? "yes" : "no");
