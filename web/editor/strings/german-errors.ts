/**
 * What the engine and the readers of files report, in German, by code, and by reason where one code has several. Apart from the
 * editor's other words: the element in a shop loads this alone.
 */
import type { TexelcastErrorJson } from "../../core/texelcast-error.ts";
import type { ErrorWords } from "./error-words.ts";
import { ARGUMENTS, BROWSERS, FONTS, PICTURES } from "./german-reasons.ts";

type Wording = (error: TexelcastErrorJson) => Told;
type Told = readonly [message: string, hint: string, told?: "whole"];

const named = ({ subject }: TexelcastErrorJson, otherwise: string): string => (subject ? `„${subject}“` : otherwise);

const of = ({ subject }: TexelcastErrorJson): string => (subject ? ` „${subject}“` : "");

const REPAIR = "Repariere das Modell in einem 3D-Programm und exportiere es noch einmal.";
const ANOTHER = "Speichere es in einem anderen Programm noch einmal, als PNG, JPEG, WebP, AVIF oder SVG.";
const RELOAD = "Prüfe die Verbindung und lade die Seite neu.";

/** Null where its reason is not known. */
function reasoned(reasons: typeof PICTURES, { reason = "" }: TexelcastErrorJson): Told | null {
  const known = Object.hasOwn(reasons, reason) ? reasons[reason] : undefined;
  return known ? [known[0], known[1], "whole"] : null;
}

/** With its reason it is told whole; without one that is known, the English words stand beside it. */
function withReason(reasons: typeof PICTURES, error: TexelcastErrorJson, begin: string, hint: string): Told {
  const told = reasoned(reasons, error);
  return told ? [`${begin} ${told[0]}`, told[1], "whole"] : [begin, hint];
}

const notLoaded = ({ subject }: TexelcastErrorJson): Told => [
  subject ? `„${subject}“ ließ sich nicht laden.` : "Ein Teil der Seite ließ sich nicht laden.",
  RELOAD,
];

const notReadable = (error: TexelcastErrorJson): Told => {
  const where = error.field === undefined ? "" : `: bei ${error.field} steht nicht, was dort stehen muss`;
  return [`${named(error, "Die Datei")} ist kein lesbares glTF-Modell${where}.`, REPAIR];
};

const FAULT: Told = [
  "In der Seite ist ein Fehler aufgetreten.",
  "Versuche es noch einmal, oder lade die Seite neu. Deine Arbeit ist noch da.",
];

/** As the engine's client, the core and the readers of files report them. */
const WORDINGS: Readonly<Record<string, Wording>> = {
  "bad-model": (error) =>
    error.reason === "which-variant"
      ? [
          `${named(error, "Das Modell")} hat keine Variante „${error.value}“.`,
          "Nenne eine, die es hat, oder lass „#variant=…“ weg.",
        ]
      : notReadable(error),
  "bad-container": (error) => notReadable(error),
  "unsupported-model": (error) => [
    `${named(error, "Das Modell")} braucht ${error.value ? `die glTF-Erweiterung ${error.value}` : "eine glTF-Erweiterung"}, die hier nicht gelesen wird.`,
    "Exportiere es ohne diese Erweiterung.",
  ],
  "bad-geometry": (error) => [`Die Geometrie von ${named(error, "diesem Modell")} ist beschädigt.`, REPAIR],
  "bad-uvs": (error) => [
    `Die Texturkoordinaten von ${named(error, "diesem Modell")} sind nicht zu gebrauchen.`,
    "Wickle das Modell in einem 3D-Programm neu ab und exportiere es noch einmal.",
  ],
  "no-uvs": (error) => [
    `${named(error, "Das Modell")} hat keine Texturkoordinaten und damit keine Textur, die man bemalen könnte.`,
    "Wickle das Modell in einem 3D-Programm ab (gib ihm Texturkoordinaten) und exportiere es noch einmal.",
    "whole",
  ],
  "no-triangles": (error) => [
    `${named(error, "Das Modell")} hat keine Dreiecke mit einem Material, das man bemalen könnte.`,
    REPAIR,
    "whole",
  ],
  "no-material": (error) => [`Dieses Material hat ${named(error, "das Modell")} nicht.`, ""],
  "bad-size": () => ["Diese Größe geht nicht.", "Wähle eine kleinere Textur oder weniger DPI."],
  "out-of-budget": () => [
    "Dafür reicht der Speicher nicht, den die Mal-Engine haben darf.",
    "Wähle eine kleinere Textur oder öffne ein kleineres Modell.",
    "whole",
  ],
  "bad-picture": (error) =>
    withReason(PICTURES, error, `${named(error, "Das Bild")} ist kein Bild, das sich hier verwenden lässt.`, ANOTHER),
  "bad-font": (error) =>
    withReason(
      FONTS,
      error,
      `${named(error, "Die Schrift")} ist keine Schrift, die sich hier verwenden lässt.`,
      "Nimm die Schrift als .ttf oder .otf.",
    ),
  "unsafe-file": (error) => [
    `${named(error, "Die Zeichnung")} enthält etwas, das ausgeführt würde, und wird nicht geöffnet.`,
    "Speichere die Zeichnung ohne Skripte noch einmal, oder als PNG.",
  ],
  "too-large": (error) => [
    `${named(error, "Das Bild")} ist zu groß${error.value === undefined ? "" : ` (${sizeOf(error.value)})`}.`,
    "Mach es kleiner und versuche es noch einmal.",
    "whole",
  ],
  "bad-design": ({ subject, field, value }) => {
    const design = subject ? `Design „${subject}“` : "Design";
    if (field === undefined) return [`Das ${design} ist nicht zu lesen.`, "Öffne eine andere Fassung davon."];
    if (field === "version" && value !== undefined) {
      return [`Das ${design} hat die Version ${value}, die hier nicht gelesen wird.`, RELOAD];
    }
    return [
      `Im ${design} steht bei ${field} nicht, was dort stehen muss.`,
      "Welche Felder ein Design hat, steht in docs/design-document.md.",
    ];
  },
  "bad-project": (error) => {
    const project = named(error, "Das Projekt");
    if (error.reason === "newer")
      return [`${project} hat die Version ${error.value}, die hier nicht gelesen wird.`, RELOAD];
    return [`${project} ist beschädigt oder kein Projekt.`, "Nimm eine andere Sicherung dieser Datei."];
  },
  "bad-archive": (error) => {
    const archive = named(error, "Das Archiv");
    if (error.reason === "without-model")
      return [
        `In ${named(error, "dem Archiv")} ist kein Modell.`,
        "Ein Modell ist eine .glb-Datei oder eine .gltf mit ihren Dateien.",
        "whole",
      ];
    if (error.reason === "which-model") {
      return [
        `${archive} enthält mehrere Modelle.`,
        "Nenne eines davon: mit seinem Pfad, hinter dem Namen des Archivs und einem „#“.",
      ];
    }
    return [
      `${archive} ließ sich nicht öffnen: es ist beschädigt, zu groß oder ungewöhnlich.`,
      "Entpacke es, und öffne die Dateien daraus.",
    ];
  },
  "bad-zones": (error) =>
    error.reason === "no-surface"
      ? error.field === "zone"
        ? [
            `Die Zone „${error.value}“ hat keine Fläche zum Bedrucken.`,
            "Eine Zone muss auf der Oberfläche ihres Materials liegen.",
            "whole",
          ]
        : [
            `Material ${error.value} von ${named(error, "diesem Modell")} hat bei dieser Größe keine Fläche zum Bedrucken.`,
            "Wähle eine größere Textur, oder wickle das Modell so ab, dass seine Teile mehr davon einnehmen.",
            "whole",
          ]
      : [
          error.field
            ? `In den Druckflächen${of(error)} steht bei ${error.field} nicht, was dort stehen muss.`
            : `Die Druckflächen${of(error)} lassen sich nicht verwenden.`,
          "Siehe docs/print-truth.md.",
        ],
  "missing-file": (error) => {
    if (error.reason === "not-loaded" || error.value === undefined) return notLoaded(error);
    return [
      `${named(error, "Die Datei")} braucht die Datei „${error.value}“, die nicht dabei ist.`,
      "Wähle oder zieh alle Dateien auf einmal.",
      "whole",
    ];
  },
  "outside-folder": (error) => [
    `${named(error, "Das Design")} nennt eine Datei außerhalb seines eigenen Ordners.`,
    "Lege die Dateien eines Designs neben das Design oder hinein.",
  ],
  unsupported: (error) =>
    reasoned(BROWSERS, error) ??
    (error.subject
      ? [
          `„${error.subject}“ enthält etwas, das hier nicht gelesen wird.`,
          "Speichere die Datei in einem anderen Format.",
        ]
      : [
          "Dieser Browser kann die 3D-Ansicht oder die Mal-Engine nicht zeigen.",
          "Schalte die Hardwarebeschleunigung ein, oder nimm einen neueren Browser.",
        ]),
  "bad-argument": (error) => reasoned(ARGUMENTS, error) ?? ["Das geht hier nicht.", ""],
  disposed: () => ["Die Mal-Engine ist beendet.", RELOAD],
  internal: () => FAULT,
  "no-model": () => ["Es ist noch kein Modell geöffnet.", "Öffne zuerst ein Modell.", "whole"],
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

/** Whatever was not said in German is, if only that it went wrong. */
export function germanError(error: TexelcastErrorJson): ErrorWords {
  const wording = Object.hasOwn(WORDINGS, error.code) ? WORDINGS[error.code] : undefined;
  const [message, hint, whole] = wording?.(error) ?? FAULT;
  return { message, hint, ...(!whole && { exact: error.message }) };
}
