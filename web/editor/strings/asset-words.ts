/**
 * What is wrong with a design's files, in each language: apart from the page's other words, because what reads designs
 * (the element in a shop) must not bring the whole editor's along.
 */
import { language } from "./language.ts";

const english = {
  badDataUri: (subject: string): string => `${subject} is not a well-formed data: address.`,
  missingAsset: (uri: string): string => `The design names the picture ${uri}, which is not part of it.`,
  missingAssetHint: "Open the design together with its pictures: choose or drop all of them at once.",
  unreachable: (address: string): string => `${address} could not be fetched.`,
};

const german: typeof english = {
  badDataUri: (subject) => `${subject} ist keine wohlgeformte data:-Adresse.`,
  missingAsset: (uri) => `Das Design nennt das Bild ${uri}, das nicht dabei ist.`,
  missingAssetHint: "Öffne das Design zusammen mit seinen Bildern: Wähle oder zieh alle auf einmal.",
  unreachable: (address) => `${address} ließ sich nicht laden.`,
};

export const assetWords = { en: english, de: german }[language];
