/** The keys in German, in the order of the English ones. */
import type { KeyGroup } from "./key-words.ts";

export const germanKeys: readonly KeyGroup[] = [
  {
    name: "Aufkleber",
    keys: [
      [
        "Pfeiltasten",
        "Die gewählten Aufkleber verschieben, auch die einer gewählten Gruppe; mit Umschalt zehnmal so weit",
      ],
      ["[ und ]", "Sie drehen; mit Umschalt zehnmal so weit"],
      ["− und +", "Sie kleiner oder größer machen"],
      ["Einen von mehreren ziehen", "Alle gewählten ziehen"],
      ["Alt und ziehen", "Eine Kopie ziehen"],
      ["Umschalt und ziehen", "Nur waagerecht oder nur senkrecht"],
      ["Strg oder ⌘ beim Ziehen", "Ohne in Flucht einzurasten"],
      ["Alt an einem Griff", "Seine Größe um seine Mitte ändern"],
      ["Umschalt beim Drehen am Griff", "In Schritten von 15°"],
      ["Alt S, Alt U, Alt V", "Den Aufkleber ausrichten: an der Oberfläche, aufrecht, an der Ansicht"],
      ["Alt M", "Ihn in die Mitte des Modells rücken"],
      ["Alt P", "Ihn aus der Ansicht projizieren"],
      ["Alt W", "Ihn rundum legen"],
    ],
  },
  {
    name: "Ebenen",
    keys: [
      ["Strg oder ⌘ A", "Alle Ebenen auswählen"],
      ["Umschalt und Klick auf das Modell", "Eine mehr auswählen, oder eine weniger"],
      ["0 bis 9", "Deckkraft der gewählten Ebenen in Zehnteln; 0 ist voll"],
      ["Entf", "Die gewählten Ebenen löschen"],
      ["Strg oder ⌘ D", "Sie duplizieren"],
      [
        "Strg oder ⌘ C, X, V",
        "Sie kopieren, ausschneiden und einfügen, auch in ein anderes Projekt; ein Bild als Aufkleber einfügen, Worte als Text",
      ],
      ["Strg oder ⌘ G", "Sie gruppieren; mit Umschalt die Gruppe auflösen"],
      ["Strg oder ⌘ E", "Mit der Ebene darunter vereinen"],
      ["Strg oder ⌘ [ und ]", "Sie nach unten oder oben schieben; mit Umschalt ganz"],
      ["Alt ↑ und ↓ in der Liste", "Sie verschieben, auch in Gruppen und heraus"],
      ["← und → in der Liste", "Eine Gruppe schließen und öffnen"],
      ["Leertaste und F2 in der Liste", "Ein- oder ausblenden; umbenennen"],
    ],
  },
  {
    name: "Werkzeuge",
    keys: [
      ["V, B, E, I, S, T", "Verschieben, Pinsel, Radierer, Pipette, Klonen, Text"],
      ["Alt oder S, und Klick", "Mit dem Klonwerkzeug: sagen, woher es kopiert"],
      ["N, G, U", "Stift, Farbeimer, Linie und Rechteck, im Pixelmodus"],
      ["[ und ] mit einem Pinsel", "Ihn kleiner oder größer machen; mit Umschalt weicher oder härter"],
      ["0 bis 9 mit einem Pinsel", "Deckkraft in Zehnteln; 0 ist alles"],
      ["Umschalt und Klick", "Eine gerade Linie vom Ende des letzten Strichs"],
      ["Alt und Klick", "Die Farbe aufnehmen, die dort liegt"],
      ["X und D", "Die beiden Farben tauschen; Schwarz und Weiß"],
      [
        "Pfeiltasten, dann Leertaste oder Eingabe",
        "Pinsel, Text, Pipette oder Teileauswahl über die Oberfläche der gewählten Ansicht bewegen und anwenden",
      ],
    ],
  },
  {
    name: "Ansicht",
    keys: [
      [
        "Pfeiltasten, − und + in der Ansicht",
        "Das Modell drehen, näher oder ferner, solange kein Aufkleber gewählt ist",
      ],
      ["Rechte Taste und ziehen", "Die Ansicht schieben"],
      ["Rechte Taste auf dem Modell", "Was mit dem Aufkleber dort getan werden kann"],
      ["Doppelklick auf einen Text", "Ihn schreiben"],
      ["Leertaste und ziehen", "Das Modell drehen oder die Textur schieben, während ein Werkzeug malt"],
      ["F", "Das ganze Modell zeigen"],
      ["Alt 1, 2, 3", "Nur das Modell, Modell und Textur, nur die Textur"],
      ["Umschalt U", "Die eigenen Farben der Texel, ohne Licht, oder wieder beleuchtet"],
      ["Umschalt W", "Drahtgitter"],
      ["Umschalt T", "Drehteller"],
      ["Umschalt G", "Beschriftung der Textur"],
      ["Umschalt L", "Ob einrastet, was gezogen wird"],
      ["Umschalt P", "Die Animation abspielen oder anhalten"],
    ],
  },
  {
    name: "Seite",
    keys: [
      ["Strg oder ⌘ Z", "Rückgängig, auch mitten im Strich oder Ziehen; mit Umschalt, oder Strg Y, wiederholen"],
      ["Strg oder ⌘ S", "Das Design speichern"],
      ["Strg oder ⌘ O", "Ein Modell öffnen"],
      ["Esc", "Ein Ziehen beenden und den Aufkleber zurücklegen, oder die Auswahl aufheben"],
      ["?", "Diese Liste"],
    ],
  },
  {
    name: "Finger",
    keys: [
      ["Zwei Finger", "Die Ansicht drehen oder schieben und zoomen"],
      ["Drei Finger", "Tippen: rückgängig; nach links oder rechts wischen: rückgängig, wiederholen"],
      ["Vier Finger", "Tippen: wiederholen"],
      ["Eine Ebene in der Liste halten", "Eine mehr auswählen, oder eine weniger"],
    ],
  },
];
