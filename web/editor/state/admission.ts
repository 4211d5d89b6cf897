/** What a page that has the editor in it says about what its visitors bring along. */

export interface Admission {
  /** Throws a TexelcastError where that many more pictures and texts would be too many. */
  checkRoom(more: number): void;
  /** A file as it may be used: checked, cleaned, accepted by the page. Rejects with a TexelcastError. */
  admit(kind: "picture" | "font", fileName: string, bytes: Uint8Array): Promise<Uint8Array>;
}
