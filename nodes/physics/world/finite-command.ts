import type { PhysicsCommand } from './protocol.ts';

/** The largest number that a command may contain; larger ones overflow in products. */
const LARGEST = 1e9;

/**
 * Whether all numbers of a command are finite and not too large for a body. A command with other numbers would spoil all bodies through
 * their contacts.
 */
export function isFiniteCommand(command: PhysicsCommand): boolean {
  // The grid leaves out single numbers of depth.
  if (command.kind === 'load-room') return isFiniteValue(command.worldFromFile);
  return command.kind === 'depth' || isFiniteValue(command);
}

function isFiniteValue(value: unknown): boolean {
  if (typeof value === 'number') return Math.abs(value) <= LARGEST;
  if (typeof value !== 'object' || value === null) return true;
  if (ArrayBuffer.isView(value)) {
    const numbers = value as unknown as ArrayLike<number>;
    for (let i = 0; i < numbers.length; i++) if (!(Math.abs(numbers[i] ?? 0) <= LARGEST)) return false;
    return true;
  }
  if (Array.isArray(value)) return value.every(isFiniteValue);
  for (const key in value) if (!isFiniteValue((value as Record<string, unknown>)[key])) return false;
  return true;
}
