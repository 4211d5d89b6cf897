/** Which of the faults of one code it is, in German: the end of the sentence that the code begins, and what to do about it. */

type Reasons = Readonly<Record<string, readonly [problem: string, hint: string]>>;

const AS_PICTURE = "Speichere es als PNG, JPEG, WebP oder AVIF.";
const AS_DRAWING = "Exportiere es als SVG, das in jeder Größe scharf bleibt, oder als PNG.";
const ONCE_MORE = "Kopiere oder lade die Datei noch einmal.";
const ANOTHER = "Speichere das Bild in einem anderen Programm noch einmal, als PNG, JPEG, WebP, AVIF oder SVG.";
const SIMPLER = "Vereinfache die Zeichnung, oder speichere sie als PNG.";
const PLAIN_SVG = "Speichere die Zeichnung in einem Zeichenprogramm noch einmal als einfaches SVG, oder als PNG.";
const OTHER_FONT = "Nimm eine andere Schrift.";

/** Of "bad-picture". */
export const PICTURES: Reasons = {
  animated: ["Es ist bewegt.", "Speichere ein Bild daraus als stehendes Bild."],
  "avif-kind": ["Es ist ein AVIF-Bild von einer Art, die nicht gelesen wird.", "Speichere es als PNG, JPEG oder WebP."],
  bits: ["Seine Farben haben nicht 8 Bit.", ANOTHER],
  bmp: ["Es ist ein BMP.", AS_PICTURE],
  channels: ["Es hat andere Farbkanäle als Grau oder RGB.", "Speichere es in RGB-Farben."],
  cmyk: ["Seine Farben sind CMYK, für Druckmaschinen.", "Speichere es in RGB-Farben."],
  "cut-short": ["Die Datei hört zu früh auf.", ONCE_MORE],
  damaged: ["Die Datei ist beschädigt.", ONCE_MORE],
  empty: ["Die Datei ist leer.", ONCE_MORE],
  encoding: ["Sein Text ist weder UTF-8 noch UTF-16.", PLAIN_SVG],
  entities: ["Es wächst durch seine Entitäten über jedes Maß.", PLAIN_SVG],
  eps: ["Es ist eine EPS-Zeichnung.", AS_DRAWING],
  film: ["Es ist ein Film.", "Speichere ein Bild daraus als stehendes Bild."],
  frames: ["Es enthält mehr Bilder, als ein stehendes hat.", AS_PICTURE],
  gif: ["Es ist ein GIF.", AS_PICTURE],
  heic: ["Es ist ein HEIC-Bild.", AS_PICTURE],
  "inner-avif": [
    "Ein Bild darin ist AVIF, das eine Zeichnung nicht zeigen kann.",
    "Setz stattdessen ein PNG, JPEG oder WebP in die Zeichnung.",
  ],
  "inner-drawing": [
    "Eine Zeichnung darin hat Filter oder ist gepackt.",
    "Zeichne, was darin ist, in die Zeichnung selbst.",
  ],
  "inner-pixels": ["Die Bilder darin haben zu viele Pixel.", "Mach sie kleiner."],
  "jpeg-kind": ["Es ist ein JPEG von einer Art, die nicht gelesen wird.", ANOTHER],
  jxl: ["Es ist ein JPEG-XL-Bild.", AS_PICTURE],
  ktx2: ["Es ist eine KTX2-Textur.", AS_PICTURE],
  "ktx2-kind": ["Es ist eine KTX2-Textur von einer Art, die nicht gelesen wird.", AS_PICTURE],
  "no-namespace": ['Ihm fehlt xmlns="http://www.w3.org/2000/svg".', PLAIN_SVG],
  "no-pixels": ["Es enthält keine Pixel.", ANOTHER],
  "no-size": ["Es hat keine Breite und Höhe über 0.", PLAIN_SVG],
  "not-well-formed": ["Es ist kein gültiges SVG.", PLAIN_SVG],
  "nothing-drawn": [
    "Es enthält nichts, was sich zeichnen lässt: Teile von Webseiten und Bilder an Adressen fallen weg.",
    PLAIN_SVG,
  ],
  pdf: ["Es ist ein PDF, wie es auch die Dateien von Illustrator sind.", AS_DRAWING],
  profile: ["Sein Farbprofil besteht aus Tabellen.", "Speichere es in sRGB-Farben."],
  psd: ["Es ist eine Photoshop-Datei.", AS_PICTURE],
  scans: ["Es geht zu oft über das ganze Bild.", "Speichere es noch einmal, als JPEG oder PNG."],
  svg: ["Es ist eine SVG-Zeichnung.", AS_PICTURE],
  svgz: ["Es ist gepackt, wie komprimiertes SVG (.svgz).", "Entpack es, oder speichere es als einfaches SVG."],
  tiff: ["Es ist ein TIFF.", AS_PICTURE],
  "too-long": ["Es ist viel zu lang für seine Breite, oder zu breit für seine Höhe.", PLAIN_SVG],
  "too-many-bytes": ["Die Datei ist zu groß für eine Zeichnung.", SIMPLER],
  "too-many-pixels": ["Es hat mehr als 8192 Pixel an einer Seite.", "Mach es kleiner."],
  "too-slow": ["Es zu zeichnen würde zu lange dauern.", SIMPLER],
  undrawable: ["Es lässt sich nicht zeichnen.", PLAIN_SVG],
  unknown: ["Es ist weder PNG, JPEG, WebP, AVIF noch SVG.", ANOTHER],
};

/** Of "bad-font". */
export const FONTS: Reasons = {
  collection: ["Es ist eine Sammlung von Schriften.", "Nimm eine einzelne, als .ttf oder .otf."],
  "cut-short": ["Die Datei hört zu früh auf.", ONCE_MORE],
  empty: ["Die Datei ist leer.", ONCE_MORE],
  "no-characters": ["Sie hat keine Zeichen.", OTHER_FONT],
  "not-shipped": ["Diese Version bringt sie nicht mit.", OTHER_FONT],
  tables: ["Ihr fehlt etwas, das ein Text braucht.", OTHER_FONT],
  "too-many-bytes": ["Die Datei ist zu groß.", "Nimm eine kleinere Schrift."],
  "too-many-points": ["Ihre Buchstaben haben zu viele Punkte.", "Nimm eine andere Schrift oder weniger Worte."],
  unknown: ["Sie ist weder TrueType noch OpenType.", "Nimm die Schrift als .ttf oder .otf."],
  woff: ["Es ist eine Webschrift (WOFF).", "Nimm die Schrift als .ttf oder .otf."],
};

/** Of "unsupported". */
export const BROWSERS: Reasons = {
  "no-engine": ["Die Mal-Engine startet in diesem Browser nicht.", "Nimm einen neueren Browser."],
  "no-origin": [
    "Eine Seite ohne eigene Herkunft darf keinen Worker starten.",
    "Gib dem sandbox-Attribut des iframes neben allow-scripts auch allow-same-origin.",
  ],
  "no-webgl": [
    "Dieser Browser kann kein 3D zeigen: WebGL 2 ist abgeschaltet oder fehlt.",
    "Schalte die Hardwarebeschleunigung ein, oder nimm einen anderen Browser.",
  ],
  "no-three": [
    "Die Seite sagt nicht, wo three.js liegt.",
    "Nimm ohne Bundler standalone.js, das es mitbringt, oder schreib eine Import-Map: beides steht in docs/guides/plain-html.md.",
  ],
  "trusted-types": [
    "Die Trusted Types der Seite lassen den Worker der Mal-Engine nicht starten.",
    "Gib der Seite die Default-Policy aus docs/guides/plain-html.md.",
  ],
};

/** Of "bad-argument": what can be asked for in the page, and what a design may ask for. */
export const ARGUMENTS: Reasons = {
  "no-layer": ["Die Ebene, in die sie soll, gibt es nicht mehr.", ""],
  "no-list": ["In diese Ebene lässt sich keine andere legen.", ""],
  "not-mirrored": ["Ein Strich, der auf der Textur liegt, lässt sich nicht spiegeln.", ""],
  "no-font": ["Die Schrift dieses Textes ist nicht da.", "Wähle eine andere Schrift."],
  "not-open": ["Dieses Material ist noch nicht bereit.", "Warte einen Moment und versuche es noch einmal."],
  "not-taken": ["Ebenen dieser Art lassen sich dort nicht einfügen.", ""],
  "other-model": [
    "Die Füllung wurde für ein anderes Modell gemacht, oder für ein anderes Material.",
    "Wähle ihre Teile neu.",
  ],
  "too-deep": ["So tief lassen sich Ebenen nicht ineinander legen.", ""],
  "too-many": ["Ein Design fasst 10.000 Ebenen und Striche, und nicht mehr.", ""],
  undrawn: ["Eine Ebene lässt sich so nicht zeichnen.", "Mach den letzten Schritt rückgängig, oder lösche sie."],
};
