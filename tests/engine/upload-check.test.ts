import { describe, expect, it } from "vitest";
import { crc32 } from "../../web/engine/crc32.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { readPictureHeader } from "../../web/engine/picture-header.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { checkUpload } from "../../web/engine/upload-check.ts";
import { type AvifPart, avifFile, box, makeAvif, partsOf, turnBox } from "../support/avif-file.ts";

const text = (value: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(value);
const svg = (inner: string, attributes = ""): Uint8Array<ArrayBuffer> =>
  text(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 30 20" ${attributes}>${inner}</svg>`);
/** With declarations in the document's type. */
const typed = (declared: string, inner = "", before = "<!DOCTYPE svg"): Uint8Array<ArrayBuffer> =>
  text(`${before} [${declared}]>${new TextDecoder().decode(svg(inner))}`);
const codeOf = (checked: Promise<unknown>): Promise<string> =>
  checked.then(
    () => "taken",
    ({ code }: { code: string }) => code,
  );

describe("an upload", () => {
  it("is what its content says, whatever it is called", async () => {
    const png = await smallPng();
    expect((await checkUpload("photo.jpg", png)).type).toBe("image/png");
    expect(await codeOf(checkUpload("logo.png", text("<html><script>alert(1)</script></html>")))).toBe("bad-picture");
  });

  it("is refused by its header's pixels before anything is decoded", async () => {
    const png = await smallPng();
    new DataView(png.buffer).setUint32(16, 8000);
    new DataView(png.buffer).setUint32(20, 8100);
    new DataView(png.buffer).setUint32(29, crc32(png.subarray(12, 29)));
    expect(await codeOf(checkUpload("huge.png", png))).toBe("too-large");
    expect(await codeOf(checkUpload("huge.png", png, { megapixels: 65 }))).toBe("taken");
  });

  it("is refused by its bytes before it is looked at", async () => {
    expect(await codeOf(checkUpload("x.png", new Uint8Array(1001), { bytes: 1000 }))).toBe("too-large");
  });

  it("loses a PNG's texts and what was appended, and keeps its pixels and the way the camera was held", async () => {
    const png = await smallPng();
    const secret = chunk("tEXt", text("Author\0Jane Doe"));
    const dirty = joined(png.slice(0, 33), secret, chunk("eXIf", tiff(6)), png.slice(33), text("appended"));
    const { bytes, width, height } = await checkUpload("p.png", dirty);
    expect([width, height]).toEqual([2, 3]);
    expect(new TextDecoder("latin1").decode(bytes)).not.toMatch(/Jane|appended/);
    expect((await readPictureHeader(bytes, "p")).orientation).toBe(6);
    expect(await decodePicture(bytes, "p", { asSeen: true })).toEqual(
      await decodePicture(dirty, "p", { asSeen: true }),
    );
    expect((await checkUpload("p.png", bytes)).bytes).toEqual(bytes);
  });

  it("loses a JPEG's camera, thumbnail and comment, and keeps its scan", async () => {
    const scan = Uint8Array.of(0xff, 0xda, 0, 2, 1, 0xff, 0, 2, 0xff, 0xd0, 3, 0xff, 0xd9);
    const frame = Uint8Array.of(0xff, 0xc0, 0, 11, 8, 0, 2, 0, 3, 1, 1, 0x11, 0);
    const exif = segment(0xe1, joined(text("Exif\0\0"), tiff(3), text("GPS 52.5 N")));
    const note = segment(0xfe, text("shot by Jane"));
    const jfif = segment(0xe0, joined(text("JFIF\0"), Uint8Array.of(1, 1, 0, 0, 1, 0, 1, 1, 1, 9, 9, 9)));
    const dirty = joined(Uint8Array.of(0xff, 0xd8), jfif, exif, note, frame, scan, text("trailer"));
    const { bytes } = await checkUpload("p.jpg", dirty);
    const kept = new TextDecoder("latin1").decode(bytes);
    expect(kept).not.toMatch(/GPS|Jane|trailer/);
    expect(bytes.slice(-scan.length)).toEqual(scan);
    expect(await readPictureHeader(bytes, "p")).toMatchObject({ width: 3, height: 2, orientation: 3 });
    expect((await checkUpload("p.jpg", bytes)).bytes).toEqual(bytes);
  });

  it("is a JPEG that ends in the midst of a segment without that segment, and the same when it is looked at again", async () => {
    const scan = Uint8Array.of(0xff, 0xda, 0, 2, 1, 2, 3);
    const frame = Uint8Array.of(0xff, 0xc0, 0, 11, 8, 0, 2, 0, 3, 1, 1, 0x11, 0);
    const begun = Uint8Array.of(0xff, 0xc4, 0, 40, 1, 2, 0xff, 0xd9);
    const { bytes } = await checkUpload("p.jpg", joined(Uint8Array.of(0xff, 0xd8), frame, scan, begun));
    expect(bytes).toEqual(joined(Uint8Array.of(0xff, 0xd8), frame, scan, Uint8Array.of(0xff, 0xd9)));
    expect((await checkUpload("p.jpg", bytes)).bytes).toEqual(bytes);
  });

  it("loses an AVIF's camera, its small copy and what was appended, and keeps its pixels, its alpha and its turn", async () => {
    const rgba = Uint8Array.from({ length: 24 }, (_, index) => index * 9);
    const [colours, alpha] = partsOf(await avifFile({ width: 3, height: 2, rgba })) as [AvifPart, AvifPart];
    const turned = { ...colours, properties: [...(colours.properties ?? []), turnBox(1)] };
    const about: AvifPart[] = [
      { type: "Exif", data: text("\0\0\0\0GPS 52.5 N"), references: { cdsc: [1] } },
      { type: "mime", data: text("<x:xmpmeta>Jane</x:xmpmeta>"), references: { cdsc: [1] } },
      { ...colours, data: joined(colours.data, text("small copy")), references: { thmb: [1] } },
    ];
    const more = [box("uuid", text("serial number 7"))];
    const dirty = joined(makeAvif({ parts: [turned, alpha, ...about], more }), text("trailer"));
    const { type, bytes, width, height } = await checkUpload("p.avif", dirty);
    expect([type, width, height]).toEqual(["image/avif", 2, 3]);
    expect(new TextDecoder("latin1").decode(bytes)).not.toMatch(/GPS|Jane|small copy|serial|trailer/);
    expect(await decodePicture(bytes, "p")).toEqual(await decodePicture(dirty, "p"));
    expect((await checkUpload("p.avif", bytes)).bytes).toEqual(bytes);
  });

  it("is no drawing that would run something", async () => {
    const hostile = [
      svg("<script>alert(1)</script>"),
      svg("<x:script xmlns:x='http://www.w3.org/2000/svg'>alert(1)</x:script>"),
      svg("", 'onload="alert(1)"'),
      svg("<g x='>' onclick='alert(1)'/>"),
      svg('<a href="javascript:alert(1)"><rect/></a>'),
      svg('<a href="java&#115;cript&colon;alert(1)"><rect/></a>'),
      svg('<a href="java\n\tscript:alert(1)"><rect/></a>'),
      svg('<set attributeName="onload" to="alert(1)"/>'),
      svg('<foreignObject><iframe src="x"/></foreignObject>'),
      text('<?xml-stylesheet href="x.css"?><svg xmlns="http://www.w3.org/2000/svg"/>'),
      text('<!DOCTYPE svg [<!ENTITY x "<script>alert(1)</script>">]><svg>&x;</svg>'),
    ];
    for (const bytes of hostile) {
      expect(await codeOf(checkUpload("x.svg", bytes)), new TextDecoder().decode(bytes)).toBe("unsafe-file");
    }
  });

  const cut = ["<metadata/>", "<metadata>a</metadata>", "<!-- -->"];
  it.each([
    ...cut.map((aside) => svg(`<scr${aside}ipt>alert(1)</scr${aside}ipt>`)),
    ...cut.map((aside) => svg("", `on${aside}load="alert(1)"`)),
    ...cut.map((aside) => svg(`<a href="java${aside}script:alert(1)"><rect/></a>`)),
    svg("<meta<metadata/>data/><script/>"),
    svg("<a.b:script xmlns:a.b='http://www.w3.org/2000/svg'>alert(1)</a.b:script>"),
    typed('<!ATTLIST svg onload CDATA "alert(1)">'),
    typed("<!ENTITY % a ''>%a;"),
    typed('<!ENTITY j "javascript">', '<a href="&j;:alert(1)"><rect/></a>'),
    typed('<!ENTITY j "j&#97;va">', '<a href="&j;script:alert(1)"><rect/></a>'),
    typed('<!ENTITY j "]>"><!ENTITY k "javascript">', '<a href="&k;:alert(1)"><rect/></a>'),
    typed("<!ENTITY j 'no'><!ENTITY o 'on'>", '<set attributeName="&o;load" to="alert(1)"/>'),
    typed(`<!ENTITY a "${"a".repeat(10_000)}">`, "&a;".repeat(10_000)),
    text(`<?xml version='1.0' encoding='iso-2022-jp'?><svg><scr\x1b(Bipt>alert(1)</scr\x1b(Bipt></svg>`),
  ])("is no drawing that would run something once it is cleaned, or read by a browser: %#", async (bytes) => {
    expect(await codeOf(checkUpload("x.svg", bytes)), new TextDecoder().decode(bytes)).toBe("unsafe-file");
  });

  it("is a drawing as drawing programs write them, and the same when it is looked at again", async () => {
    const illustrator = typed(
      `<!-- Generator --><!ENTITY ns_svg "http://www.w3.org/2000/svg">
       <!ENTITY ns_ai 'http://ns.adobe.com/AdobeIllustrator/10.0/'><!ENTITY st0 "fill:none;stroke:#000000;"><!ENTITY nbsp "&#160;">
       <!ELEMENT svg ANY>`,
      '<metadata><metadata/>&nbsp;</metadata><g xmlns:i="&ns_ai;" style="&st0;" x="a>b"><![CDATA[<!-- kept -->]]></g>',
      `<?xml version="1.0" encoding="utf-8"?><!-- Jane --><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "svg11.dtd"`,
    );
    const { bytes } = await checkUpload("x.svg", illustrator);
    const kept = new TextDecoder().decode(bytes);
    expect(kept).not.toMatch(/Jane|Generator|metadata|encoding/);
    expect(kept).toContain('<g xmlns:i="&ns_ai;" style="&st0;" x="a>b"><![CDATA[<!-- kept -->]]></g>');
    expect((await checkUpload("x.svg", bytes)).bytes).toEqual(bytes);
  });

  it("is a drawing without its comments and its author", async () => {
    const drawn = '<rect width="10" height="10"/>';
    const { bytes, width, height } = await checkUpload(
      "x.svg",
      svg(`<!-- Jane --><metadata><a>Jane</a></metadata>${drawn}`),
    );
    expect(new TextDecoder().decode(bytes)).toBe(new TextDecoder().decode(svg(drawn)));
    expect([width, height]).toEqual([30, 20]);
  });

  it("is a drawing of its viewBox's size where it gives one length alone, as icons do", async () => {
    for (const half of ['height="1em"', 'width="90"', 'width="100%" height="10"']) {
      const { width, height } = await checkUpload("x.svg", svg("", half));
      expect([half, width, height]).toEqual([half, 30, 20]);
    }
    const { width, height } = await checkUpload("x.svg", svg("", 'width="3in" height="2in"'));
    expect([width, height]).toEqual([3, 2]);
  });
});

async function smallPng(): Promise<Uint8Array<ArrayBuffer>> {
  const rgba = Uint8Array.from({ length: 24 }, (_, index) => (index % 4 === 3 ? 255 : index * 9));
  return encodePng({ width: 3, height: 2, rgba });
}

function tiff(orientation: number): Uint8Array {
  return Uint8Array.of(
    0x4d,
    0x4d,
    0,
    42,
    0,
    0,
    0,
    8,
    0,
    1,
    1,
    0x12,
    0,
    3,
    0,
    0,
    0,
    1,
    0,
    orientation,
    0,
    0,
    0,
    0,
    0,
    0,
  );
}

function chunk(type: string, data: Uint8Array): Uint8Array {
  const bytes = joined(new Uint8Array(4), text(type), data, new Uint8Array(4));
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  view.setUint32(8 + data.length, crc32(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

const segment = (marker: number, data: Uint8Array): Uint8Array =>
  joined(Uint8Array.of(0xff, marker, 0, data.length + 2), data);

function joined(...parts: Uint8Array[]): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(parts.flatMap((part) => [...part]));
}
