/** What the printer would say of a design, in German, by code. A code that is not here keeps its own words. */
import type { ErrorWords } from "../../editor/strings/error-words.ts";
import type { PrintFinding } from "../../engine/print-report.ts";

const MOVE_IN = "Schieb es hinein, oder mach es kleiner.";

export function germanFinding(
  { code, value, zone, message, hint, characters = [] }: PrintFinding,
  grave: boolean,
): ErrorWords {
  switch (code) {
    case "low-dpi":
      return {
        message: grave
          ? `Nur ${value} DPI: Es wird unscharf gedruckt.`
          : `${value} DPI: Feine Einzelheiten werden weich.`,
        hint: "Nimm ein Bild mit mehr Pixeln, oder mach es kleiner.",
      };
    case "outside-zones": {
      const cut = grave ? "" : " und werden abgeschnitten";
      return { message: `${value} % davon liegen außerhalb der Druckfläche${cut}.`, hint: MOVE_IN };
    }
    case "safe-margin":
      return {
        message: `${value} % davon liegen so nah am Rand der Druckfläche, dass sie abgeschnitten werden könnten.`,
        hint: "Schieb nach innen, was wichtig ist.",
      };
    case "nothing-printed":
      return { message: "Nichts davon wird gedruckt.", hint: "Schieb es auf die Fläche, in die Druckfläche hinein." };
    case "clipped":
      return { message: `${value} % des Bildes liegen auf keiner Fläche.`, hint: MOVE_IN };
    case "hidden":
      return {
        message: `${value} % des Bildes sind verdeckt oder auf einer abgewandten Seite.`,
        hint: "Dreh es zur Fläche hin, oder schieb es weiter.",
      };
    case "stretched":
      return {
        message: `Das Bild ist auf der Fläche um ${value} % gedehnt.`,
        hint: "Gib ihm seine eigenen Proportionen, und richte es an der Fläche aus.",
      };
    case "appears-twice":
      return {
        message: "Dieses Zeichen erscheint zweimal: Teile des Modells haben denselben Platz in der Textur.",
        hint: "Schieb es dorthin, wo das Modell für sich allein abgewickelt ist.",
      };
    case "mirrored":
      return {
        message: "Die Textur liegt dort gespiegelt: Flach gedruckt liest es sich von rechts nach links.",
        hint: "Drucke diese Zone flach ausgelegt.",
      };
    case "not-printable":
      return { message: "Dieser Teil lässt sich nicht bedrucken.", hint: "Schieb es auf einen anderen Teil." };
    case "missing-characters":
      return {
        message: `Keine Schrift hat ${characters.join(" ")}: Stattdessen würden Platzhalter gedruckt.`,
        hint: "Nimm eine Schrift, die sie hat, oder andere Worte.",
      };
    case "zone-without-material":
      return {
        message: `Die Druckfläche „${zone}“ liegt auf einem Material, das das Modell nicht hat.`,
        hint: "Gib ihr ein Material des Modells.",
      };
    default:
      return { message, hint };
  }
}
