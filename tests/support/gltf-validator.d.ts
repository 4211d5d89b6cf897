/** The part of Khronos's validator that the tests use; the package has no types of its own. */
declare module "gltf-validator" {
  export interface ValidationMessage {
    readonly code: string;
    readonly message: string;
    /** 0 error, 1 warning, 2 information, 3 hint. */
    readonly severity: number;
    readonly pointer?: string;
  }
  export interface ValidatedResource {
    readonly pointer: string;
    readonly image?: { readonly width: number; readonly height: number };
  }
  export function validateBytes(glb: Uint8Array): Promise<{
    readonly issues: { readonly messages: ValidationMessage[] };
    readonly info: { readonly resources: ValidatedResource[] };
  }>;
}
