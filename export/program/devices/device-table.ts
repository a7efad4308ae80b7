import type { Capability } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { ProgramNeed, Tier } from '../needs.ts';
import type { Program } from '../program.ts';
import { WEBXR_FEATURES } from '../webxr-features.ts';
import { DEVICE_FACTS, type DeviceFact, type DeviceFacts, type DeviceKind } from './device-facts.ts';

/** How a page plays on one kind of device. */
export interface DeviceRow {
  readonly kind: DeviceKind;
  readonly title: string;
  /** The best tier of the program that the device can open. */
  readonly tier: Tier['id'];
  readonly display: DeviceFacts['display'];
  /** What the page loses there, one entry per capability and node. Empty: everything works. */
  readonly lost: readonly DeviceLoss[];
  /** On additive displays: nodes whose layers only darken, so that they are invisible there. */
  readonly unseen: readonly string[];
  /** Whether a node requires a feature that the device lacks, so that the page shows nothing of use. */
  readonly worthless: boolean;
}

/** A node that works less on a kind of device. */
export interface DeviceLoss {
  readonly node: string;
  readonly capability: Capability;
  /** What the visitor sees instead, as a sentence. */
  readonly effect: string;
  readonly required: boolean;
  /** Why: the feature is missing, or no source tells whether the device has it. */
  readonly fact: DeviceFact;
}

/**
 * The table of devices of a program, for `scrim plan`, the editor and the report of an export.
 *
 * @returns One row per kind of device, in the order of {@link DEVICE_FACTS}.
 *
 * @example
 * const iphone = deviceTable(program).find(({ kind }) => kind === 'iphone');
 */
export function deviceTable({ needs, tiers, operations }: Pick<Program, 'needs' | 'tiers' | 'operations'>): DeviceRow[] {
  const darkening = operations.filter((operation) => 'type' in operation && DARKENING.includes(operation.type)).map(({ node }) => node);
  return DEVICE_FACTS.map((facts) => {
    const tier = facts.sessions.find((session) => tiers.some(({ id }) => id === session)) ?? 'orbit';
    const lost = needs.flatMap((need) => lossesOf(need, facts, tier));
    const { kind, title, display } = facts;
    const unseen = display === 'additive' ? [...new Set(darkening)] : [];
    return { kind, title, tier, display, lost, unseen, worthless: lost.some(({ required, fact }) => required && fact.has === 'no') };
  });
}

/**
 * Warnings about nodes that make a page worthless on kinds of devices.
 *
 * @returns One SCR076 per node, which names all those kinds.
 *
 * @example
 * deviceWarnings(deviceTable(program)).map(({ nodeId }) => nodeId);
 */
export function deviceWarnings(rows: readonly DeviceRow[]): Diagnostic[] {
  const titles = new Map<string, string[]>();
  for (const { title, lost } of rows) {
    const nodes = new Set(lost.flatMap(({ node, required, fact }) => (required && fact.has === 'no' ? [node] : [])));
    for (const node of nodes) titles.set(node, [...(titles.get(node) ?? []), title]);
  }
  return [...titles].map(([nodeId, devices]) => ({
    code: 'SCR076',
    severity: 'warning',
    nodeId,
    message: `The page shows nothing of use on these devices, which lack what ${nodeId} requires: ${devices.join('; ')}.`,
    fix: 'Replace the node, or tell visitors which devices they need.',
  }));
}

/** Node types whose layers contain nothing but black; “Negative shadow” takes their place on additive displays. */
const DARKENING: readonly string[] = ['layer/shadow'];

function lossesOf(need: ProgramNeed, facts: DeviceFacts, tier: Tier['id']): DeviceLoss[] {
  const fact = factIn(tier, need.capability, facts);
  if (fact.has === 'yes') return [];
  return need.nodes.map((node) => ({
    node,
    capability: need.capability,
    effect: need.withoutByNode?.[node] ?? need.without,
    required: need.required,
    fact,
  }));
}

const VIRTUAL_ROOM: DeviceFact = { has: 'yes', source: 'The virtual room takes the place of the camera image', date: '2026-11' };
const NOT_IN_TIER: DeviceFact = { has: 'no', source: 'This kind of session has no such feature', date: '2026-11' };

/** Whether a device has a feature in the sessions of a tier. */
function factIn(tier: Tier['id'], capability: Capability, { features }: DeviceFacts): DeviceFact {
  // The page asks for these itself, in any kind of session.
  if (capability === 'microphone' || capability === 'motion' || capability === 'location') return features[capability];
  switch (tier) {
    case 'ar-camera':
      return features[capability];
    case 'ar':
      return capability === 'camera-image' ? NOT_IN_TIER : features[capability];
    case 'camera':
      return capability === 'camera-image' ? features[capability] : NOT_IN_TIER;
    case 'authored-vr':
      if (capability === 'camera-image') return VIRTUAL_ROOM;
      return capability === 'hands' ? features.hands : NOT_IN_TIER;
    case 'orbit':
      return NOT_IN_TIER;
  }
}

/**
 * WebXR features that an emulator refuses so that it plays like a kind of device. Features that no source tells of are refused, too.
 *
 * @returns Feature descriptors.
 *
 * @example
 * refusedFeatures('quest'); // ['camera-access', 'light-estimation', 'dom-overlay']
 */
export function refusedFeatures(kind: DeviceKind): string[] {
  const { features } = DEVICE_FACTS.find((facts) => facts.kind === kind) as DeviceFacts;
  return (Object.keys(features) as (keyof typeof features)[]).flatMap((feature) => {
    const name = feature === 'dom-overlay' ? feature : WEBXR_FEATURES[feature];
    return name === null || features[feature].has === 'yes' ? [] : [name];
  });
}
