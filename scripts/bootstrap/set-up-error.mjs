/** Something about this machine or checkout that the user can put right; its message says how, and is all they see. */
export class SetUpError extends Error {}
