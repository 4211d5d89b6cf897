/**
 * The fonts that come with Texelcast, all under the SIL Open Font License. A design names one by its address,
 * "texelcast:fonts/inter-700", which leads to the same bytes in the browser and in Node, without a network.
 */
import { fontAddress, fontIdIn } from "./font-address.ts";
import { type PackageFile, readPackageFile } from "./package-file.ts";

export interface ShippedFont {
  /** As people know it. */
  readonly name: string;
  readonly weight: 400 | 700;
  readonly file: PackageFile;
  /** Scripts (ISO 15924) in which this font stands in for one that lacks them. */
  readonly standsInFor?: readonly string[];
}

/** Emoji as a script; ISO 15924. */
export const EMOJI = "Zsye";

/** By id; the order is the one in which people are offered them. */
const FONTS = {
  "inter-400": {
    name: "Inter",
    weight: 400,
    file: {
      specifier: "@expo-google-fonts/inter/400Regular/Inter_400Regular.ttf",
      url: () => new URL("@expo-google-fonts/inter/400Regular/Inter_400Regular.ttf", import.meta.url),
    },
  },
  "inter-700": {
    name: "Inter Bold",
    weight: 700,
    file: {
      specifier: "@expo-google-fonts/inter/700Bold/Inter_700Bold.ttf",
      url: () => new URL("@expo-google-fonts/inter/700Bold/Inter_700Bold.ttf", import.meta.url),
    },
  },
  "source-serif-4-400": {
    name: "Source Serif",
    weight: 400,
    file: {
      specifier: "@expo-google-fonts/source-serif-4/400Regular/SourceSerif4_400Regular.ttf",
      url: () => new URL("@expo-google-fonts/source-serif-4/400Regular/SourceSerif4_400Regular.ttf", import.meta.url),
    },
  },
  "source-serif-4-700": {
    name: "Source Serif Bold",
    weight: 700,
    file: {
      specifier: "@expo-google-fonts/source-serif-4/700Bold/SourceSerif4_700Bold.ttf",
      url: () => new URL("@expo-google-fonts/source-serif-4/700Bold/SourceSerif4_700Bold.ttf", import.meta.url),
    },
  },
  "jetbrains-mono-700": {
    name: "JetBrains Mono",
    weight: 700,
    file: {
      specifier: "@expo-google-fonts/jetbrains-mono/700Bold/JetBrainsMono_700Bold.ttf",
      url: () => new URL("@expo-google-fonts/jetbrains-mono/700Bold/JetBrainsMono_700Bold.ttf", import.meta.url),
    },
  },
  "bebas-neue-400": {
    name: "Bebas Neue",
    weight: 400,
    file: {
      specifier: "@expo-google-fonts/bebas-neue/400Regular/BebasNeue_400Regular.ttf",
      url: () => new URL("@expo-google-fonts/bebas-neue/400Regular/BebasNeue_400Regular.ttf", import.meta.url),
    },
  },
  "lobster-400": {
    name: "Lobster",
    weight: 400,
    file: {
      specifier: "@expo-google-fonts/lobster/400Regular/Lobster_400Regular.ttf",
      url: () => new URL("@expo-google-fonts/lobster/400Regular/Lobster_400Regular.ttf", import.meta.url),
    },
  },
  "press-start-2p-400": {
    name: "Press Start 2P",
    weight: 400,
    file: {
      specifier: "@expo-google-fonts/press-start-2p/400Regular/PressStart2P_400Regular.ttf",
      url: () => new URL("@expo-google-fonts/press-start-2p/400Regular/PressStart2P_400Regular.ttf", import.meta.url),
    },
  },
  "noto-sans-arabic-400": {
    name: "Noto Sans Arabic",
    weight: 400,
    standsInFor: ["Arab"],
    file: {
      specifier: "@expo-google-fonts/noto-sans-arabic/400Regular/NotoSansArabic_400Regular.ttf",
      url: () =>
        new URL("@expo-google-fonts/noto-sans-arabic/400Regular/NotoSansArabic_400Regular.ttf", import.meta.url),
    },
  },
  "noto-sans-arabic-700": {
    name: "Noto Sans Arabic Bold",
    weight: 700,
    standsInFor: ["Arab"],
    file: {
      specifier: "@expo-google-fonts/noto-sans-arabic/700Bold/NotoSansArabic_700Bold.ttf",
      url: () => new URL("@expo-google-fonts/noto-sans-arabic/700Bold/NotoSansArabic_700Bold.ttf", import.meta.url),
    },
  },
  "noto-sans-hebrew-400": {
    name: "Noto Sans Hebrew",
    weight: 400,
    standsInFor: ["Hebr"],
    file: {
      specifier: "@expo-google-fonts/noto-sans-hebrew/400Regular/NotoSansHebrew_400Regular.ttf",
      url: () =>
        new URL("@expo-google-fonts/noto-sans-hebrew/400Regular/NotoSansHebrew_400Regular.ttf", import.meta.url),
    },
  },
  "noto-sans-hebrew-700": {
    name: "Noto Sans Hebrew Bold",
    weight: 700,
    standsInFor: ["Hebr"],
    file: {
      specifier: "@expo-google-fonts/noto-sans-hebrew/700Bold/NotoSansHebrew_700Bold.ttf",
      url: () => new URL("@expo-google-fonts/noto-sans-hebrew/700Bold/NotoSansHebrew_700Bold.ttf", import.meta.url),
    },
  },
  "noto-sans-devanagari-400": {
    name: "Noto Sans Devanagari",
    weight: 400,
    standsInFor: ["Deva"],
    file: {
      specifier: "@expo-google-fonts/noto-sans-devanagari/400Regular/NotoSansDevanagari_400Regular.ttf",
      url: () =>
        new URL(
          "@expo-google-fonts/noto-sans-devanagari/400Regular/NotoSansDevanagari_400Regular.ttf",
          import.meta.url,
        ),
    },
  },
  "noto-sans-devanagari-700": {
    name: "Noto Sans Devanagari Bold",
    weight: 700,
    standsInFor: ["Deva"],
    file: {
      specifier: "@expo-google-fonts/noto-sans-devanagari/700Bold/NotoSansDevanagari_700Bold.ttf",
      url: () =>
        new URL("@expo-google-fonts/noto-sans-devanagari/700Bold/NotoSansDevanagari_700Bold.ttf", import.meta.url),
    },
  },
  "noto-emoji-400": {
    name: "Noto Emoji",
    weight: 400,
    standsInFor: [EMOJI],
    file: {
      specifier: "@expo-google-fonts/noto-emoji/400Regular/NotoEmoji_400Regular.ttf",
      url: () => new URL("@expo-google-fonts/noto-emoji/400Regular/NotoEmoji_400Regular.ttf", import.meta.url),
    },
  },
  "noto-emoji-700": {
    name: "Noto Emoji Bold",
    weight: 700,
    standsInFor: [EMOJI],
    file: {
      specifier: "@expo-google-fonts/noto-emoji/700Bold/NotoEmoji_700Bold.ttf",
      url: () => new URL("@expo-google-fonts/noto-emoji/700Bold/NotoEmoji_700Bold.ttf", import.meta.url),
    },
  },
} as const satisfies Record<string, ShippedFont>;

export type ShippedFontId = keyof typeof FONTS;

export const SHIPPED_FONTS: Readonly<Record<ShippedFontId, ShippedFont>> = FONTS;

/** As `fontAddress`, of fonts that there are. */
export const shippedFontAddress = (id: ShippedFontId): string => fontAddress(id);

/** The font that an address names; undefined for other addresses, and for fonts that do not come with this version. */
export function shippedFontOf(uri: string): ShippedFontId | undefined {
  const id = fontIdIn(uri);
  return Object.hasOwn(FONTS, id) ? (id as ShippedFontId) : undefined;
}

/** Rejects with "missing-file". */
export async function readShippedFont(id: ShippedFontId): Promise<Uint8Array<ArrayBuffer>> {
  return await readPackageFile(FONTS[id].file, `The font ${FONTS[id].name}`);
}

/** The font that stands in for one of that weight which lacks a character of the script. */
export function standIn(script: string, weight: 400 | 700): ShippedFontId {
  const ids = Object.keys(FONTS) as ShippedFontId[];
  const found = ids.find((id) => {
    const font: ShippedFont = FONTS[id];
    return font.weight === weight && font.standsInFor?.includes(script);
  });
  return found ?? (weight === 700 ? "inter-700" : "inter-400");
}
