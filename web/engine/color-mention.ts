/** Whether a file may say anything of its picture's colours: how that is read is loaded by the first that does. */

/** What a JPEG's segments of a profile begin with. */
export const JPEG_MARK = "ICC_PROFILE\0";

const MENTIONS = /ICC_PROFILE\0|iCCP|cICP|ICCP|colr/;
/** It stands before the pixels, behind EXIF and other segments of at most 64 KiB. */
const FRONT = 2 ** 20;

export const mentionsColors = (bytes: Uint8Array): boolean =>
  MENTIONS.test(new TextDecoder("latin1").decode(bytes.subarray(0, FRONT)));
