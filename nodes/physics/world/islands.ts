import type { ContactList } from './contact.ts';
import type { RigidBody } from './rigid-body.ts';

/** Slower bodies count as at rest, meters and radians per second. */
const REST_MPS = 0.02;
const REST_RADPS = 0.06;
/** Bodies with a smaller gap count as touching, meters. */
const TOUCHING_M = 0.002;
/** Time at rest after which an island sleeps. */
const REST_S = 0.5;

/**
 * Puts islands to sleep that have been at rest. An island is a group of bodies that touch or are joined; they sleep and wake together,
 * because a body must not sleep while its support moves.
 *
 * @param joined Pairs of bodies that joints link.
 */
export function updateSleep(
  bodies: readonly RigidBody[],
  contacts: ContactList,
  joined: Iterable<readonly [RigidBody, RigidBody]>,
  isAllowed: boolean,
  stepS: number,
): void {
  for (const body of bodies) body.island = body;
  for (let i = 0; i < contacts.count; i++) {
    const { a, b, maxImpulse } = contacts.at(i);
    if (maxImpulse > 0) unite(a, b);
  }
  for (const [a, b] of joined) unite(a, b);
  for (const body of bodies) {
    if (!body.isDynamic || body.sleeps) continue;
    const { velocity: v, angularVelocity: w } = body;
    const isSlow = isAllowed && v.lengthSquared() < REST_MPS ** 2 && w.lengthSquared() < REST_RADPS ** 2;
    body.restS = isSlow ? body.restS + stepS : 0;
  }
  // The root of an island rests as long as the body that rests the least.
  for (const body of bodies) {
    if (!body.isDynamic || body.sleeps) continue;
    const root = rootOf(body);
    if (body.restS < root.restS) root.restS = body.restS;
  }
  for (const body of bodies) {
    if (!body.isDynamic) continue;
    const root = rootOf(body);
    const rests = !root.isDynamic || root.sleeps ? body.restS : root.restS;
    if (!body.sleeps && rests >= REST_S) body.rest();
  }
}

/**
 * Wakes sleeping bodies that an awake or moving body touches or will touch in this step. Returns whether it has woken one. Call it before
 * the contacts are solved.
 */
export function wakeTouched(contacts: ContactList, stepS: number): boolean {
  let hasWoken = false;
  for (let i = 0; i < contacts.count; i++) {
    const { a, b, gapM, nx, ny, nz } = contacts.at(i);
    if (a.sleeps === b.sleeps) continue;
    const { velocity: v } = a;
    const { velocity: u } = b;
    const closingMps = (v.x - u.x) * nx + (v.y - u.y) * ny + (v.z - u.z) * nz;
    if (gapM > Math.max(TOUCHING_M, closingMps * stepS)) continue;
    const awake = a.sleeps ? b : a;
    const asleep = a.sleeps ? a : b;
    const moves = awake.isDynamic || awake.velocity.lengthSquared() > 1e-8 || awake.angularVelocity.lengthSquared() > 1e-8;
    if (!moves) continue;
    asleep.wake();
    hasWoken = true;
  }
  return hasWoken;
}

function rootOf(body: RigidBody): RigidBody {
  let root = body;
  while (root.island !== root) root = root.island;
  let at = body;
  while (at.island !== root) {
    const next = at.island;
    at.island = root;
    at = next;
  }
  return root;
}

function unite(a: RigidBody, b: RigidBody): void {
  if (!a.isDynamic || !b.isDynamic) return;
  const p = rootOf(a);
  const q = rootOf(b);
  if (p === q) return;
  // The one added first, so that the result does not depend on the order of contacts.
  if (p.key < q.key) q.island = p;
  else p.island = q;
}
