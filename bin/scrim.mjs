#!/usr/bin/env node
import { resolve } from 'node:path';
import process from 'node:process';
import { buildTargets } from '../tools/build-targets.mjs';

// Builds what is out of date (a look at the files' times when nothing is), then runs the command line.
process.setSourceMapsEnabled(true);
const args = process.argv.slice(2);
await buildTargets(args[0] === 'open' ? ['registry', 'cli', 'electron', 'editor', 'preview'] : ['registry', 'cli'], console.error);
const { main } = await import('../dist/cli/main.mjs');
process.exitCode = await main(args, resolve(import.meta.dirname, '..'));
