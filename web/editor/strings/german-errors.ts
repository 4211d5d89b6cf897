/**
 * What the engine and the readers of files report, in German, by code. Apart from the editor's other words: the element in a shop
 * loads this alone. A code that is not here keeps its own words.
 */
import type { TexelcastErrorJson } from "../../core/texelcast-error.ts";
import { type ErrorWords, ownWords } from "./error-words.ts";

type Wording = (error: TexelcastErrorJson) => readonly [message: string, hint: string] | null;

const named = ({ subject }: TexelcastErrorJson, otherwise: string): string => (subject ? `„${subject}“` : otherwise);
/** What only those need who look into the file: as the reader of the file said it. */
const exactly = ({ message }: TexelcastErrorJson): string => ` Genauer: ${message}`;

const REPAIR = "Repariere das Modell in einem 3D-Programm und exportiere es noch einmal.";
const ANOTHER = "Speichere es in einem anderen Programm noch einmal, als PNG, JPEG, WebP oder SVG.";

const WORDINGS: Readonly<Record<string, Wording>> = {
  "bad-model": (error) => [`${named(error, "Die Datei")} ist kein lesbares glTF-Modell.${exactly(error)}`, REPAIR],
  "bad-container": (error) => [`${named(error, "Die Datei")} ist kein lesbares glTF-Modell.${exactly(error)}`, REPAIR],
  "unsupported-model": (error) => [
    `${named(error, "Das Modell")} braucht eine glTF-Erweiterung, die hier nicht gelesen wird.${exactly(error)}`,
    "Exportiere es ohne diese Erweiterung.",
  ],
  "bad-geometry": (error) => [
    `Die Geometrie von ${named(error, "diesem Modell")} ist beschädigt.${exactly(error)}`,
    REPAIR,
  ],
  "bad-uvs": (error) => [
    `Die Texturkoordinaten von ${named(error, "diesem Modell")} sind nicht zu gebrauchen.${exactly(error)}`,
    "Wickle das Modell in einem 3D-Programm neu ab und exportiere es noch einmal.",
  ],
  "no-uvs": (error) => [
    `${named(error, "Das Modell")} hat keine Texturkoordinaten und damit keine Textur, die man bemalen könnte.`,
    "Wickle das Modell in einem 3D-Programm ab (gib ihm Texturkoordinaten) und exportiere es noch einmal.",
  ],
  "no-triangles": (error) => [
    `${named(error, "Das Modell")} hat keine Dreiecke mit einem Material, das man bemalen könnte.`,
    REPAIR,
  ],
  "no-material": (error) => [`Dieses Material hat ${named(error, "das Modell")} nicht.${exactly(error)}`, ""],
  "bad-size": (error) => [`Diese Größe geht nicht.${exactly(error)}`, "Wähle eine kleinere Textur oder weniger DPI."],
  "out-of-budget": () => [
    "Dafür reicht der Speicher nicht, den die Mal-Engine haben darf.",
    "Wähle eine kleinere Textur oder öffne ein kleineres Modell.",
  ],
  "bad-picture": (error) => [
    `${named(error, "Das Bild")} ist kein Bild, das sich hier verwenden lässt.${exactly(error)}`,
    ANOTHER,
  ],
  "bad-font": (error) => [
    `${named(error, "Die Schrift")} ist keine Schrift, die sich hier verwenden lässt.${exactly(error)}`,
    "Nimm die Schrift als .ttf oder .otf.",
  ],
  "unsafe-file": (error) => [
    `${named(error, "Die Zeichnung")} enthält etwas, das ausgeführt würde, und wird nicht geöffnet.${exactly(error)}`,
    "Speichere die Zeichnung ohne Skripte noch einmal, oder als PNG.",
  ],
  "too-large": (error) => [
    `${named(error, "Das Bild")} ist zu groß${error.value === undefined ? "" : ` (${sizeOf(error.value)})`}.`,
    "Mach es kleiner und versuche es noch einmal.",
  ],
  "bad-design": (error) => [
    `${named(error, "Das Design")} lässt sich nicht öffnen.${exactly(error)}`,
    "Welche Felder ein Design hat, steht in docs/design-document.md.",
  ],
  "bad-project": (error) => [
    `${named(error, "Das Projekt")} ist beschädigt oder kein Projekt.${exactly(error)}`,
    "Nimm eine andere Sicherung dieser Datei.",
  ],
  "bad-zones": (error) =>
    error.subject === undefined
      ? null
      : [
          `${named(error, "Die Druckflächen")} lassen sich nicht verwenden.${exactly(error)}`,
          "Siehe docs/print-truth.md.",
        ],
  "missing-file": (error) =>
    error.value === undefined
      ? null
      : [
          `${named(error, "Die Datei")} braucht die Datei „${error.value}“, die nicht dabei ist.`,
          "Wähle oder zieh alle Dateien auf einmal.",
        ],
  "no-model": () => ["Es ist noch kein Modell geöffnet.", "Öffne zuerst ein Modell."],
  "engine-crashed": () => [
    "Die Mal-Engine ist stehen geblieben.",
    "Sie beginnt von selbst wieder; hilft das nicht, lade die Seite neu.",
  ],
  "engine-halted": () => [
    "Die Mal-Engine bleibt immer wieder stehen.",
    "Mach den letzten Schritt rückgängig, er kann der Grund sein. Deine Arbeit ist noch da.",
  ],
};

/** Bytes as megabytes; pixels as they are. */
const sizeOf = (value: string): string =>
  /^\d+$/.test(value) ? `${(Number(value) / 2 ** 20).toFixed(1).replace(".", ",")} MB` : `${value} Pixel`;

export function germanError(error: TexelcastErrorJson): ErrorWords {
  const wording = Object.hasOwn(WORDINGS, error.code) ? WORDINGS[error.code]?.(error) : null;
  if (!wording) return ownWords(error);
  const [message, hint] = wording;
  return { message, hint };
}
