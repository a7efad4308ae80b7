"""Color tables for color-lut.test.ts, and what colour-science makes of pictures with them.

Run once, by hand, after a change: `python color-lut.py PATH_TO_ASTRONAUT_PNG` with what filters.py names. The look is our own.
"""
import os
import sys

import colour
import numpy as np
from filters import HERE, read, recoloured, save, straight


def look(rgb):
    """Shadows towards teal, lights towards orange, colors crossed over a little."""
    luma = (rgb @ np.array([0.2126, 0.7152, 0.0722]))[..., None]
    toned = rgb + (luma - 0.5) * np.array([0.25, 0.02, -0.3])
    return np.clip(toned[..., [0, 1, 2]] * 0.85 + rgb[..., [1, 2, 0]] * 0.15, 0, 1) ** np.array([0.8, 1, 1.25])


def write(name, head, entries):
    lines = [' '.join(f'{v:.5f}' for v in entry) for entry in entries]
    with open(os.path.join(HERE, name), 'w') as file:
        file.write('\n'.join([f'TITLE "{name}"', '# Made by color-lut.py', *head, *lines]) + '\n')


def main():
    axis = np.linspace(0, 1, 9)
    # Red counts fastest.
    b, g, r = np.meshgrid(axis, axis, axis, indexing='ij')
    write('look.cube', ['LUT_3D_SIZE 9', 'DOMAIN_MIN 0.0 0.0 0.0', 'DOMAIN_MAX 1.0 1.0 1.0'], look(np.dstack([r.ravel(), g.ravel(), b.ravel()])[0]))
    steps = np.linspace(0, 1, 8)
    write('curve.cube', ['LUT_1D_SIZE 8'], np.column_stack([steps**1.4, steps, 1 - (1 - steps) ** 1.6]))
    pictures = {'generated': read(os.path.join(HERE, 'generated.png')), 'astronaut': read(sys.argv[1])[:256, 128:384]}
    for name, picture in pictures.items():
        for table in ('look', 'curve'):
            lut = colour.read_LUT(os.path.join(HERE, f'{table}.cube'))
            how = {'interpolator': colour.algebra.table_interpolation_trilinear} if table == 'look' else {}
            graded = recoloured(picture, lut.apply(straight(picture), **how))
            save(f'{name}-color-lut-{table}', graded[7::8, 5::8] if name == 'astronaut' else graded)


if __name__ == '__main__':
    main()
