"""Expected pictures for shader-library.test.ts, made with other people's implementations.

Run once, by hand, after a change: `python shader-library.py PATH_TO_COFFEE_PNG` with opencv-python-headless 5.0.0,
colour-science 0.4.7 and numpy. Tests read the PNG files beside this script and need no Python.

coffee.png: scikit-image's example photograph by Rachel Michetti, CC0 1.0; a 96 x 64 crop is stored.
All pictures are RGBA, premultiplied, display-referred sRGB.
"""
import os
import sys
import warnings

import cv2
import numpy as np

warnings.filterwarnings('ignore')
import colour  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
LUMA_709 = np.array([0.2126, 0.7152, 0.0722])


def save(name, rgba):
    rgba = np.clip(np.rint(rgba), 0, 255).astype(np.uint8)
    cv2.imwrite(os.path.join(HERE, f'{name}.png'), cv2.cvtColor(rgba, cv2.COLOR_RGBA2BGRA), [cv2.IMWRITE_PNG_COMPRESSION, 9])


def generated():
    """Flat areas, hard and soft edges, thin lines, every level of alpha."""
    x, y = np.meshgrid(np.arange(96), np.arange(64))
    rgb = np.stack([x * 255 / 95, y * 255 / 63, ((x // 8 + y // 8) % 2) * 255], axis=-1)
    disc = (x - 30) ** 2 + (y - 30) ** 2 < 18**2
    rgb[disc] = [240, 60, 30]
    rgb[:, 64:66] = 255
    rgb[40:41, :] = 0
    alpha = np.full((64, 96), 255.0)
    alpha[:, 48:] = 255 * (63 - y[:, 48:]) / 63
    alpha[disc] = 128
    alpha[52:, :24] = 0
    premultiplied = np.rint(rgb * alpha[..., None] / 255)
    return np.dstack([premultiplied, alpha])


def photograph(path):
    rgb = cv2.cvtColor(cv2.imread(path), cv2.COLOR_BGR2RGB)[150:214, 240:336]
    return np.dstack([rgb, np.full(rgb.shape[:2], 255)]).astype(np.float64)


def gaussian(rgba, sigma):
    side = 2 * int(np.ceil(3 * sigma)) + 1
    return cv2.GaussianBlur(rgba, (side, side), sigma, borderType=cv2.BORDER_REPLICATE)


def sobel(rgba):
    luma = rgba[..., :3] @ LUMA_709
    dx = cv2.Sobel(luma, cv2.CV_64F, 1, 0, ksize=3, borderType=cv2.BORDER_REPLICATE)
    dy = cv2.Sobel(luma, cv2.CV_64F, 0, 1, ksize=3, borderType=cv2.BORDER_REPLICATE)
    edge = np.clip(np.hypot(dx, dy) / 4, 0, 255)
    reach = cv2.dilate(rgba[..., 3], np.ones((3, 3)), borderType=cv2.BORDER_REPLICATE)
    return np.dstack([edge * reach / 255] * 3 + [reach])


def temperature(rgba, kelvin):
    alpha = rgba[..., 3:]
    straight = np.divide(rgba[..., :3], alpha, out=np.zeros_like(rgba[..., :3]), where=alpha > 0)
    xyz = colour.sRGB_to_XYZ(straight)
    white = [colour.xy_to_XYZ(colour.temperature.CCT_to_xy_Kang2002(k)) for k in (6500, kelvin)]
    adapted = colour.adaptation.chromatic_adaptation_VonKries(xyz, *white, transform='Bradford')
    linear = np.clip(colour.XYZ_to_sRGB(adapted, apply_cctf_encoding=False), 0, 1)
    return np.dstack([colour.cctf_encoding(linear, function='sRGB') * alpha, alpha])


def main():
    inputs = {'generated': generated(), 'photograph': photograph(sys.argv[1])}
    for name, rgba in inputs.items():
        save(name, rgba)
        for sigma in (1.3, 6):
            save(f'{name}-gaussian-{sigma}', gaussian(rgba, sigma))
        save(f'{name}-sobel', sobel(rgba))
        for kelvin in (2800, 11000):
            save(f'{name}-temperature-{kelvin}', temperature(rgba, kelvin))


main()
