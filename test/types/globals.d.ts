// What @types/node would bring: the one class of Node that the declarations name.
interface Buffer extends Uint8Array {
  readonly parent: ArrayBufferLike;
}
