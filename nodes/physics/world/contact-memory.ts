import type { Contact, ContactList } from './contact.ts';
import type { RigidBody } from './rigid-body.ts';

/** Keeps the impulses of contacts from one step to the next, by pair of bodies. */
export interface ContactMemory {
  /**
   * Writes to each contact the impulses of the nearest contact of the step before, for a warm start.
   *
   * @param ratio Length of this step divided by that of the step before.
   */
  recall(contacts: ContactList, ratio: number): void;
  /**
   * Keeps the impulses of this step, and those of bodies that sleep on each other: their contacts are not found again before they wake, and
   * a stack that woke without them would sag.
   */
  keep(contacts: ContactList): void;
  /** Whether the pair pressed on each other in the last step that was kept. */
  touched(pair: number): boolean;
  forget(): void;
}

interface Kept {
  a: RigidBody;
  b: RigidBody;
  pair: number;
  lx: number;
  ly: number;
  lz: number;
  nx: number;
  ny: number;
  nz: number;
  normal: number;
  /** The friction impulse as a vector in world axes, because the tangents of a contact are chosen again in each step. */
  fx: number;
  fy: number;
  fz: number;
  rollX: number;
  rollY: number;
  rollZ: number;
  isTaken: boolean;
}

/** Greatest distance between two points that count as the same contact in consecutive steps. */
const SAME_POINT_M = 0.02;
const SAME_NORMAL = 0.9;

export function createContactMemory(): ContactMemory {
  let pool: Kept[] = [];
  let former: Kept[] = [];
  let count = 0;
  /** For each pair, the index of its first entry; the contacts of a pair are consecutive. */
  const firstOf = new Map<number, number>();
  const pressed = new Set<number>();

  function recallOne(contact: Contact, ratio: number): void {
    const first = firstOf.get(contact.pair);
    if (first === undefined) return;
    let best: Kept | null = null;
    let least = SAME_POINT_M * SAME_POINT_M;
    for (let i = first; i < count; i++) {
      const kept = pool[i];
      if (!kept || kept.pair !== contact.pair) break;
      if (kept.isTaken || kept.nx * contact.nx + kept.ny * contact.ny + kept.nz * contact.nz < SAME_NORMAL) continue;
      const d = (kept.lx - contact.lx) ** 2 + (kept.ly - contact.ly) ** 2 + (kept.lz - contact.lz) ** 2;
      if (d >= least) continue;
      least = d;
      best = kept;
    }
    if (!best) return;
    best.isTaken = true;
    contact.wasMatched = best.normal > 0;
    contact.normalImpulse = best.normal * ratio;
    contact.tangentImpulse = (best.fx * contact.tx + best.fy * contact.ty + best.fz * contact.tz) * ratio;
    contact.otherTangentImpulse = (best.fx * contact.ux + best.fy * contact.uy + best.fz * contact.uz) * ratio;
    contact.rollX = best.rollX * ratio;
    contact.rollY = best.rollY * ratio;
    contact.rollZ = best.rollZ * ratio;
  }

  return {
    recall: (contacts, ratio) => {
      for (let i = 0; i < contacts.count; i++) recallOne(contacts.at(i), ratio);
    },
    keep: (contacts) => {
      firstOf.clear();
      pressed.clear();
      const formerCount = count;
      [pool, former] = [former, pool];
      count = contacts.count;
      for (let i = 0; i < count; i++) {
        const contact = contacts.at(i);
        let kept = pool[i];
        if (!kept) {
          kept = createKept(contact);
          pool.push(kept);
        }
        write(kept, contact);
        if (contact.maxImpulse > 0) pressed.add(contact.pair);
        if (!firstOf.has(contact.pair)) firstOf.set(contact.pair, i);
      }
      const found = count;
      for (let i = 0; i < formerCount; i++) {
        const kept = former[i];
        if (!kept || !rests(kept.a) || !rests(kept.b) || (firstOf.get(kept.pair) ?? found) < found) continue;
        // Both lists keep as many objects as they had.
        const spare = pool[count];
        pool[count] = kept;
        if (spare) former[i] = spare;
        else former[i] = createKept(kept);
        kept.isTaken = false;
        pressed.add(kept.pair);
        if (!firstOf.has(kept.pair)) firstOf.set(kept.pair, count);
        count++;
      }
    },
    touched: (pair) => pressed.has(pair),
    forget: () => {
      firstOf.clear();
      pressed.clear();
      count = 0;
    },
  };
}

/** Whether a body does not move before something wakes it. */
function rests({ isDynamic, sleeps }: RigidBody): boolean {
  return sleeps || !isDynamic;
}

function createKept({ a, b }: Pick<Kept, 'a' | 'b'>): Kept {
  const numbers = { pair: 0, lx: 0, ly: 0, lz: 0, nx: 0, ny: 0, nz: 0, normal: 0, fx: 0, fy: 0, fz: 0, rollX: 0, rollY: 0, rollZ: 0 };
  return { a, b, ...numbers, isTaken: false };
}

function write(kept: Kept, contact: Contact): void {
  const { tangentImpulse: t, otherTangentImpulse: u } = contact;
  kept.a = contact.a;
  kept.b = contact.b;
  kept.pair = contact.pair;
  kept.lx = contact.lx;
  kept.ly = contact.ly;
  kept.lz = contact.lz;
  kept.nx = contact.nx;
  kept.ny = contact.ny;
  kept.nz = contact.nz;
  kept.normal = contact.normalImpulse;
  kept.fx = t * contact.tx + u * contact.ux;
  kept.fy = t * contact.ty + u * contact.uy;
  kept.fz = t * contact.tz + u * contact.uz;
  kept.rollX = contact.rollX;
  kept.rollY = contact.rollY;
  kept.rollZ = contact.rollZ;
  kept.isTaken = false;
}
