import process from 'node:process';
import { buildTargets, TARGETS } from './build-targets.mjs';

// `npm run build [-- TARGET…]`: everything that is out of date, or of the targets named.
const names = process.argv.slice(2);
const unknown = names.filter((name) => !Object.hasOwn(TARGETS, name));
if (unknown.length > 0) {
  console.error(`There is no target ${unknown.join(', ')}; there are ${Object.keys(TARGETS).join(', ')}.`);
  process.exitCode = 2;
} else {
  const built = await buildTargets(names.length === 0 ? Object.keys(TARGETS) : names, console.log);
  console.log(built === 0 ? 'Everything is up to date.' : 'Built.');
}
