/** Numbers, dates and messages as people read them. */

const LOCALE = document.documentElement.lang || undefined;

/** @param amount in the currency's smallest unit */
export function formatPrice(amount: number, currency: string): string {
  const format = new Intl.NumberFormat(LOCALE, { style: "currency", currency });
  return format.format(amount / 10 ** (format.resolvedOptions().maximumFractionDigits ?? 2));
}

export const formatCount = (count: number): string => new Intl.NumberFormat(LOCALE).format(count);

/** "1.4 MB" */
export function formatBytes(bytes: number): string {
  const mega = bytes >= 1e6;
  const unit = mega ? "megabyte" : "kilobyte";
  return new Intl.NumberFormat(LOCALE, { style: "unit", unit, maximumFractionDigits: mega ? 1 : 0 }).format(
    bytes / (mega ? 1e6 : 1e3),
  );
}

export const formatDate = (iso: string): string =>
  new Intl.DateTimeFormat(LOCALE, { dateStyle: "long", timeStyle: "short" }).format(new Date(iso));

/** Messages of the server's begin small, as they follow a file's name elsewhere. */
export const asSentence = (message: string): string =>
  `${message.charAt(0).toUpperCase()}${message.slice(1)}${/[.!?]$/.test(message) ? "" : "."}`;
