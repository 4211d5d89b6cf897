/** What a picture may have at most where a shop says nothing else: bytes of its file. */
export const MOST_UPLOAD_BYTES = 20_971_520;
