import type { SessionInput } from './session.ts';

/**
 * Takes the keys for a node, as when its object is touched. Until `freeKeys`, or until another node takes them, the frames list keys
 * (`SessionInput.keys`) and the page's own use of keys, such as turning the view, stops.
 *
 * @param owner Any object of the node; the node's context serves.
 *
 * @example
 * if (claimPointer(pointer, ctx)) ownKeys(frame.input, ctx);
 */
export function ownKeys(input: SessionInput, owner: object): void {
  input.keyOwner = owner;
}

/**
 * Gives the keys back to the page, if they are the node's.
 *
 * @example
 * dispose: () => freeKeys(ctx.session.frame.input, ctx),
 */
export function freeKeys(input: SessionInput, owner: object): void {
  if (input.keyOwner === owner) input.keyOwner = null;
}
