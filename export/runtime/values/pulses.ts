import type { NewPulse, Pulse, PulseList, PulseOutput } from '../../../nodes/kit/runtime.ts';
import { PULSE_CAPACITY } from '../../../nodes/kit/runtime.ts';

/** The pulses that one output emits in a frame. */
export interface PulseQueue extends PulseOutput {
  /** Called for each pulse beyond the limit. */
  onOverflow: (() => void) | null;
  clear(): void;
}

export function createPulseQueue(): PulseQueue {
  return new FixedQueue();
}

/** The pulses of all outputs that are connected to a port, in the order of the wires. */
export interface MergedPulses extends PulseList {
  /** Connects the port to the wires of a recompiled program. */
  point(lists: readonly PulseList[]): void;
}

export function createMergedPulses(lists: readonly PulseList[]): MergedPulses {
  return new MergedLists(lists);
}

class Event implements Pulse, NewPulse {
  number = 0;
  text = '';
  bodyKey = '';
  worldFromPose: Float32Array | null = null;
  private readonly pose = new Float32Array(16);

  setPose(worldFromPose: ArrayLike<number>): void {
    this.pose.set(worldFromPose);
    this.worldFromPose = this.pose;
  }

  become(like: Pulse | undefined): void {
    this.number = like?.number ?? 0;
    this.text = like?.text ?? '';
    this.bodyKey = like?.bodyKey ?? '';
    this.worldFromPose = null;
    if (like?.worldFromPose) this.setPose(like.worldFromPose);
  }
}

class FixedQueue implements PulseQueue {
  count = 0;
  onOverflow: (() => void) | null = null;
  private readonly events = Array.from({ length: PULSE_CAPACITY }, () => new Event());
  /** The pulse that `emit` returns beyond the limit; it is dropped. */
  private readonly spare = new Event();

  at(index: number): Pulse {
    const event = index < this.count ? this.events[index] : undefined;
    if (!event) throw new RangeError(`There is no pulse ${index} of ${this.count}.`);
    return event;
  }

  emit(like?: Pulse): NewPulse {
    const event = this.events[this.count];
    if (event) this.count++;
    else this.onOverflow?.();
    const taken = event ?? this.spare;
    taken.become(like);
    return taken;
  }

  clear(): void {
    this.count = 0;
  }
}

class MergedLists implements MergedPulses {
  constructor(private lists: readonly PulseList[]) {}

  get count(): number {
    let count = 0;
    for (let i = 0; i < this.lists.length; i++) count += this.lists[i]?.count ?? 0;
    return count;
  }

  at(index: number): Pulse {
    let rest = index;
    for (let i = 0; i < this.lists.length; i++) {
      const list = this.lists[i];
      if (!list) continue;
      if (rest < list.count) return list.at(rest);
      rest -= list.count;
    }
    throw new RangeError(`There is no pulse ${index} of ${this.count}.`);
  }

  point(lists: readonly PulseList[]): void {
    this.lists = lists;
  }
}
