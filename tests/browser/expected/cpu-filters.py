"""Expected pictures for CPU filters (nodes/filter/cpu-*), made without Scrim: with OpenCV.

Run once, by hand, after a change: `python cpu-filters.py PATH_TO_ASTRONAUT_PNG` with opencv-python-headless 5.0.0 and numpy 2.4.
Pictures are as in filters.py; of the photograph every 8th pixel is stored, from (5, 7) on. OpenCV knows no alpha, so the generated
picture is taken where it is opaque.
"""
import os
import sys

import cv2
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))


def brightness(rgb):
    """Y of YCrCb alone: hues stay."""
    ycc = cv2.cvtColor(rgb, cv2.COLOR_RGB2YCrCb)
    ycc[..., 0] = cv2.equalizeHist(ycc[..., 0])
    return cv2.cvtColor(ycc, cv2.COLOR_YCrCb2RGB)


def channels(rgb):
    return np.dstack([cv2.equalizeHist(np.ascontiguousarray(rgb[..., c])) for c in range(3)])


def save(name, rgb):
    cv2.imwrite(os.path.join(HERE, f'{name}.png'), cv2.cvtColor(rgb, cv2.COLOR_RGB2BGR), [cv2.IMWRITE_PNG_COMPRESSION, 9])


def main():
    photograph = cv2.cvtColor(cv2.imread(sys.argv[1]), cv2.COLOR_BGR2RGB)[:256, 128:384]
    # Dim, and of a narrow range: what the filter is for.
    y, x = np.mgrid[0:64, 0:96]
    dim = np.dstack([60 + x // 3, 70 + (x * y) // 240, 90 - y // 2]).astype(np.uint8)
    save('dim', dim)
    for name, apply in (('brightness', brightness), ('channels', channels)):
        save(f'dim-equalize-histogram-{name}', apply(dim))
        save(f'astronaut-equalize-histogram-{name}', apply(np.ascontiguousarray(photograph))[7::8, 5::8])


if __name__ == '__main__':
    main()
