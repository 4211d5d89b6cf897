/**
 * The Latin letter that a key means, in lower case; what the key says else. By its place on the keyboard where a layout has another
 * script's letter there (Cyrillic, Greek, Hebrew, Arabic): so do browsers and systems with their own Ctrl Z.
 */
export function letterOf({ key, code }: Pick<KeyboardEvent, "key" | "code">): string {
  // Behind all of ASCII. Other places than a letter's give what is no letter.
  return (key > "~" ? code.replace("Key", "") : key).toLowerCase();
}
