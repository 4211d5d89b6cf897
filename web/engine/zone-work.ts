/** What an engine does with zones, loaded when it is given the first. */
export { coreZones } from "./core-zones.ts";
export { ZoneClip } from "./zone-clip-picture.ts";
