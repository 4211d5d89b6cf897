/** How a design names a font that comes with Texelcast. Apart from the fonts themselves: most who ask have no text to set. */
const ADDRESS = "texelcast:fonts/";

/** "inter-700" gives "texelcast:fonts/inter-700": what stands in a design. */
export const fontAddress = (id: string): string => ADDRESS + id;

/** Whether the address is one of ours, be there such a font or not. */
export const isShippedFontAddress = (uri: string): boolean => uri.startsWith(ADDRESS);

/** The id in an address of ours; "" of other addresses. */
export const fontIdIn = (uri: string): string => (isShippedFontAddress(uri) ? uri.slice(ADDRESS.length) : "");
