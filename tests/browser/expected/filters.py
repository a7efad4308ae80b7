"""Expected pictures for filters.test.ts, made without Scrim: with numpy, OpenCV, scikit-image, SciPy and colour-science.

Run once, by hand, after a change: `python filters.py PATH_TO_ASTRONAUT_PNG [CASES THAT BEGIN SO…]` with numpy 2.4, opencv-python-headless 5.0.0,
scikit-image 0.26, scipy 1.17 and colour-science 0.4.7. Tests read the PNG files beside this script and need no Python.

generated.png is made by shader-library.py. astronaut.png is scikit-image's photograph of Eileen Collins by NASA, public domain;
it is not stored. Its 256 x 256 pixels from (128, 0) on are used, and of what is expected every 8th is stored, from (5, 7) on.
All pictures are RGBA, premultiplied, display-referred sRGB, top row first; formulas work on floats from 0 to 1.
"""
import os
import sys
import warnings

import cv2
import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.ndimage import map_coordinates
from skimage.transform import swirl as skimage_swirl

warnings.filterwarnings('ignore')
import colour  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
LUMA_709 = np.array([0.2126, 0.7152, 0.0722])
DIAGONAL = [0, 0, 1, 1]


def read(path):
    picture = cv2.imread(path, cv2.IMREAD_UNCHANGED)
    if picture.shape[2] == 3:
        picture = np.dstack([picture, np.full(picture.shape[:2], 255, np.uint8)])
    return cv2.cvtColor(picture, cv2.COLOR_BGRA2RGBA).astype(np.float64) / 255


def save(name, rgba):
    rgba = np.clip(np.rint(rgba * 255), 0, 255).astype(np.uint8)
    cv2.imwrite(os.path.join(HERE, f'{name}.png'), cv2.cvtColor(rgba, cv2.COLOR_RGBA2BGRA), [cv2.IMWRITE_PNG_COMPRESSION, 9])


def straight(rgba):
    alpha = rgba[..., 3:]
    return np.divide(rgba[..., :3], alpha, out=np.zeros_like(rgba[..., :3]), where=alpha > 0)


def premultiplied(rgb, alpha):
    return np.dstack([np.clip(rgb, 0, 1) * alpha[..., None], alpha])


def recoloured(rgba, rgb):
    return premultiplied(rgb, rgba[..., 3])


def grid(rgba):
    """x and y of pixel centers, y up, and the size."""
    height, width = rgba.shape[:2]
    x, y = np.meshgrid(np.arange(width) + 0.5, height - (np.arange(height) + 0.5))
    return x, y, width, height


def sample(rgba, x, y):
    """Bilinear, y up; beyond the edge is the nearest pixel."""
    rows, columns = rgba.shape[0] - y - 0.5, x - 0.5
    return np.dstack([map_coordinates(rgba[..., i], [rows, columns], order=1, mode='nearest') for i in range(4)])


# One pixel at a time


def grey(rgba, amount=1):
    rgb = straight(rgba)
    return recoloured(rgba, rgb * (1 - amount) + (rgb @ LUMA_709)[..., None] * amount)


def to_ycbcr(rgb):
    return colour.RGB_to_YCbCr(rgb, K=colour.WEIGHTS_YCBCR['ITU-R BT.709'], in_legal=False, out_legal=False)


def from_ycbcr(ycbcr):
    return colour.YCbCr_to_RGB(ycbcr, K=colour.WEIGHTS_YCBCR['ITU-R BT.709'], in_legal=False, out_legal=False)


def luminance(rgba, brightness, contrast, gamma):
    ycbcr = to_ycbcr(straight(rgba))
    ycbcr[..., 0] = np.clip((np.clip(ycbcr[..., 0], 0, 1) ** (1 / gamma) - 0.5) * contrast + 0.5 + brightness, 0, 1)
    return recoloured(rgba, from_ycbcr(ycbcr))


def chrominance(rgba, saturation, rotation, blue_yellow, red_cyan):
    ycbcr = to_ycbcr(straight(rgba))
    turned = (ycbcr[..., 1] + 1j * ycbcr[..., 2]) * saturation * np.exp(1j * rotation) + blue_yellow + 1j * red_cyan
    ycbcr[..., 1], ycbcr[..., 2] = turned.real, turned.imag
    return recoloured(rgba, from_ycbcr(ycbcr))


def vignette(rgba, amount=0.7, start=0.35, softness=0.65, roundness=0, tint=(0, 0, 0)):
    x, y, width, height = grid(rgba)
    longer = max(width, height)
    sx, sy = 1 - roundness + roundness * width / longer, 1 - roundness + roundness * height / longer
    far = np.hypot((x / width * 2 - 1) * sx, (y / height * 2 - 1) * sy) / np.hypot(sx, sy)
    t = np.clip((far - start) / softness, 0, 1)
    cover = (amount * (3 * t**2 - 2 * t**3))[..., None]
    return recoloured(rgba, straight(rgba) * (1 - cover) + np.array(tint) * cover)


def posterize(rgba, levels):
    """As a table: value i of n covers the i-th of n equal parts of 0 to 1."""
    bins = np.digitize(np.round(straight(rgba), 7), np.round(np.arange(1, levels) / levels, 7))
    return recoloured(rgba, np.linspace(0, 1, levels)[bins])


def curve(points, x):
    xs, ys = points[::2], points[1::2]
    return PchipInterpolator(xs, ys)(np.clip(x, xs[0], xs[-1]))


def curves(rgba, every, red=DIAGONAL, green=DIAGONAL, blue=DIAGONAL, luma=DIAGONAL, amount=1):
    before = straight(rgba)
    rgb = np.dstack([curve(one, curve(every, before[..., i])) for i, one in enumerate([red, green, blue])])
    bright = (rgb @ LUMA_709)[..., None]
    rgb = rgb + curve(luma, bright) - bright
    return recoloured(rgba, before + (rgb - before) * amount)


def chroma_key(rgba, key=(0, 0.7, 0.2), tolerance=0.15, softness=0.1, spill=0.5):
    ycbcr = to_ycbcr(straight(rgba))
    k = to_ycbcr(np.array(key, float))[1:]
    chroma = ycbcr[..., 1:]
    opaque = np.clip((np.linalg.norm(chroma - k, axis=-1) - tolerance) / softness, 0, 1)
    k /= np.linalg.norm(k)
    ycbcr[..., 1:] = chroma - spill * np.maximum(chroma @ k, 0)[..., None] * k
    return premultiplied(from_ycbcr(ycbcr), rgba[..., 3] * opaque)


def skin(rgba, softness, widen=0, cut_out=False):
    cbcr = colour.RGB_to_YCbCr(straight(rgba), K=colour.WEIGHTS_YCBCR['ITU-R BT.601'], in_legal=False, out_legal=True)[..., 1:] * 255
    low, high = np.array([77, 133]) - widen, np.array([127, 173]) + widen
    outside = np.max(np.maximum(low - cbcr, cbcr - high), axis=-1)
    found = np.clip(1 - outside / softness, 0, 1)
    if cut_out:
        return premultiplied(straight(rgba), rgba[..., 3] * found)
    return recoloured(rgba, np.dstack([found] * 3))


def planckian_xy(kelvin):
    return colour.temperature.CCT_to_xy_Kang2002(kelvin)


def white_balance(rgba, warm, cold, balance):
    kelvin = 1 / ((1 - balance) / warm + balance / cold)
    white, neutral = (colour.xy_to_XYZ(planckian_xy(k)) for k in (kelvin, 6500))
    xyz = colour.RGB_to_XYZ(straight(rgba), 'sRGB', apply_cctf_decoding=True)
    adapted = colour.adaptation.chromatic_adaptation_VonKries(xyz, neutral, white, transform='Bradford')
    return recoloured(rgba, colour.XYZ_to_RGB(adapted, 'sRGB', apply_cctf_encoding=True))


def exposure(rgba, stops, highlights=0):
    light = colour.cctf_decoding(straight(rgba), function='sRGB') * 2.0**stops
    white = max(2.0**stops, 1)
    compressed = light * (1 + light / white**2) / (1 + light)
    light = (1 - highlights) * np.minimum(light, 1) + highlights * compressed
    return recoloured(rgba, colour.cctf_encoding(np.clip(light, 0, 1), function='sRGB'))


def film_grain(rgba, amount, size=1, color=0, midtones=0.5):
    """The permutation in whole numbers, which cannot round."""
    x, y, *_ = grid(rgba)
    cx, cy = (np.floor(v / size).astype(np.int64) for v in (x, y))
    cx, cy = cx + cy // 509 * 37, cy + cx // 509 * 101

    def permute(v):
        return v**3 % 509

    def grain(channel):
        seeds = [permute((permute((permute(a % 509) + b) % 509)) % 509) for a, b in ((cx, cy), (cy + 11, cx + 11))]
        total = 0
        for i in (1, 2):
            seeds = [permute((seed + 4 * channel + i) % 509) for seed in seeds]
            total = total + sum((seed + 0.5) / 509 for seed in seeds)
        return (total - 2) * np.sqrt(3)

    rgb = straight(rgba)
    luma = rgb @ LUMA_709
    strength = amount * (1 - midtones + midtones * 4 * luma * (1 - luma))
    noise = (1 - color) * grain(3)[..., None] + color * np.dstack([grain(0), grain(1), grain(2)])
    return recoloured(rgba, rgb + strength[..., None] * noise)


def halftone(rgba, size, angle, picture_colors=False):
    x, y, *_ = grid(rgba)
    turned = (x + 1j * y) * np.exp(-1j * angle) / size
    spot = 0.5 - 0.25 * (np.cos(2 * np.pi * turned.real) + np.cos(2 * np.pi * turned.imag))
    rise = np.pi / 2 / size
    rgb = straight(rgba)
    darkness = (1 - rgb @ LUMA_709) * (1 + rise) - rise / 2
    ink = np.clip((darkness - spot) / rise + 0.5, 0, 1)[..., None]
    return recoloured(rgba, (rgb if picture_colors else np.zeros_like(rgb)) * ink + 1 - ink)


# Pixels that move


def pixelate(rgba, size):
    """Blocks from the bottom left; OpenCV averages whole ones, and the last of a row or column by itself."""
    up = rgba[::-1]
    result = np.empty_like(up)
    for top in range(0, up.shape[0], size):
        for left in range(0, up.shape[1], size):
            block = up[top : top + size, left : left + size]
            result[top : top + size, left : left + size] = cv2.resize(block, (1, 1), interpolation=cv2.INTER_AREA)[0, 0]
    return result[::-1]


def swirl(rgba, angle, radius):
    height, width = rgba.shape[:2]
    # The angle falls to 2 ** -10 at the radius; to exp(-5 / ln 2) at that of scikit-image.
    radius /= 2 * np.log(2) ** 2
    return np.dstack([
        skimage_swirl(rgba[..., i], center=((width - 1) / 2, (height - 1) / 2), strength=angle, radius=radius, order=1, mode='edge')
        for i in range(4)
    ])


def tile(rgba, columns, rows, mirror=False):
    height, width = rgba.shape[:2]
    copy = cv2.resize(rgba, (width // columns, height // rows), interpolation=cv2.INTER_AREA)
    lines = []
    for row in range(rows):
        line = [copy[:, ::-1] if mirror and column % 2 else copy for column in range(columns)]
        line = np.hstack(line)
        # Rows count from the bottom.
        lines.insert(0, line[::-1] if mirror and row % 2 else line)
    return np.vstack(lines)


def smear(rgba, length, place):
    """Mean of ceil(length) samples at most 64, at the middles of equal parts of 0 to 1."""
    count = np.clip(np.ceil(length), 1, 64)
    total = np.zeros_like(rgba)
    for i in range(64):
        part = (i + 0.5) / count
        total += sample(rgba, *place(part)) * (i < count)[..., None]
    return total / count[..., None]


def radial_blur(rgba, amount, center=(0.5, 0.5)):
    x, y, width, height = grid(rgba)
    cx, cy = center[0] * width, center[1] * height
    length = amount * np.hypot(x - cx, y - cy)
    return smear(rgba, length, lambda part: (cx + (x - cx) * (1 - amount * part), cy + (y - cy) * (1 - amount * part)))


def spin_blur(rgba, angle, center=(0.5, 0.5)):
    x, y, width, height = grid(rgba)
    middle = center[0] * width + 1j * center[1] * height
    offset = x + 1j * y - middle

    def place(part):
        turned = middle + offset * np.exp(1j * angle * (part - 0.5))
        return turned.real, turned.imag

    return smear(rgba, angle * np.abs(offset), place)


# Neighborhoods


def kuwahara(rgba, radius, sharpness):
    side = radius + 1
    total, weights = 0, 0
    for anchor in ((0, 0), (radius, 0), (0, radius), (radius, radius)):
        mean, square = (
            cv2.boxFilter(v, cv2.CV_64F, (side, side), anchor=anchor, borderType=cv2.BORDER_REPLICATE) for v in (rgba, rgba**2)
        )
        deviation = 255 * np.sqrt(np.maximum(square - mean**2, 0).sum(axis=-1, keepdims=True))
        weight = 1 / (1 + deviation**sharpness)
        total, weights = total + weight * mean, weights + weight
    return total / weights


def anisotropic_kuwahara(rgba, radius, sharpness, stretch=1):
    up = rgba[::-1]
    padded = np.pad(up, ((17, 17), (17, 17), (0, 0)), mode='edge')
    height, width = up.shape[:2]

    def near(i, j):
        return padded[17 + j :, 17 + i :][:height, :width]

    # Sobel's differences of the padded picture; OpenCV's own.
    gx, gy = (cv2.Sobel(padded, cv2.CV_64F, *order, ksize=3, scale=0.25)[17:-17, 17:-17] for order in ((1, 0), (0, 1)))
    tensor = np.dstack([(gx * gx).sum(-1), (gy * gy).sum(-1), (gx * gy).sum(-1)])
    tensor = cv2.GaussianBlur(tensor, (13, 13), 2, borderType=cv2.BORDER_REPLICATE)
    matrices = np.stack([tensor[..., [0, 2]], tensor[..., [2, 1]]], axis=-2)
    values, vectors = np.linalg.eigh(matrices)
    total = values.sum(-1)
    anisotropy = stretch * np.divide(values[..., 1] - values[..., 0], total, out=np.zeros_like(total), where=total > 0)
    way = vectors[..., 0]
    longer, shorter = radius * (1 + anisotropy), radius / (1 + anisotropy)
    zeta, shared = 2 / radius, 3 * np.pi / 16
    eta = (zeta + np.cos(shared)) / np.sin(shared) ** 2
    sums, squares = np.zeros((8, height, width, 4)), np.zeros((8, height, width, 4))
    weights = np.zeros((8, height, width, 1))
    for j in range(-16, 17):
        for i in range(-16, 17):
            v = (i * way[..., 0] + j * way[..., 1]) / longer + 1j * (j * way[..., 0] - i * way[..., 1]) / shorter
            inside = np.abs(v) <= 1
            if not inside.any():
                continue
            turned = v * np.exp(-0.25j * np.pi * np.arange(8))[:, None, None]
            share = np.maximum(turned.real + zeta - eta * turned.imag**2, 0) ** 2
            falloff = np.exp(-2 * np.abs(v) ** 2) * np.maximum(1 - np.abs(v) ** 4, 0)
            share = (share * falloff / np.maximum(share.sum(0), 1e-12))[..., None]
            color = near(i, j)
            sums, squares, weights = sums + share * color, squares + share * color**2, weights + share
    mean = sums / weights
    deviation = 255 * np.sqrt(np.maximum(squares / weights - mean**2, 0).sum(-1, keepdims=True))
    calm = 1 / (1 + deviation**sharpness)
    return ((mean * calm).sum(0) / calm.sum(0))[::-1]


def bilateral(rgba, radius, color_range):
    """OpenCV's own filter where nothing is transparent; it has no fourth channel."""
    if rgba[..., 3].min() == 1:
        rgb = np.ascontiguousarray(rgba[..., :3], np.float32)
        smooth = cv2.bilateralFilter(rgb, 2 * radius + 1, color_range, radius / 2, borderType=cv2.BORDER_REPLICATE)
        return np.dstack([smooth, rgba[..., 3]])
    padded = np.pad(rgba, ((radius, radius), (radius, radius), (0, 0)), mode='edge')
    total, weights = 0, 0
    for dy in range(-radius, radius + 1):
        for dx in range(-radius, radius + 1):
            if dx * dx + dy * dy > radius * radius:
                continue
            near = padded[radius + dy :, radius + dx :][: rgba.shape[0], : rgba.shape[1]]
            difference = np.abs(near - rgba).sum(axis=-1, keepdims=True)
            weight = np.exp(-0.5 * ((dx * dx + dy * dy) / (radius / 2) ** 2 + (difference / color_range) ** 2))
            total, weights = total + weight * near, weights + weight
    return total / weights


def gaussian(image, sigma, reach):
    side = 2 * int(reach) + 1
    return cv2.GaussianBlur(image, (side, side), sigma, borderType=cv2.BORDER_REPLICATE)


def dog_lines(rgba, radius, strength, level, hardness, over_picture=False):
    luma = rgba[..., :3] @ LUMA_709 + 1 - rgba[..., 3]
    reach = np.ceil(3 * 1.6 * radius)
    narrow, wide = gaussian(luma, radius, reach), gaussian(luma, 1.6 * radius, reach)
    sharp = (1 + strength) * narrow - strength * wide
    light = np.where(sharp >= level, 1, 1 + np.tanh(hardness * (sharp - level)))[..., None]
    alpha = rgba[..., 3:]
    paper = rgba if over_picture else np.dstack([alpha] * 4)
    ink = np.dstack([np.zeros_like(rgba[..., :3]), alpha])
    return light * paper + (1 - light) * ink


def bloom(rgba, level, radius, strength):
    height, width = rgba.shape[:2]
    alpha = rgba[..., 3:]
    light = colour.cctf_decoding(straight(rgba), function='sRGB') * alpha
    luma = (light @ LUMA_709)[..., None]
    bright = light * np.maximum(luma - level, 0) / np.maximum(luma, 1e-4)
    half = cv2.resize(bright, (width // 2, height // 2), interpolation=cv2.INTER_AREA)
    glow = gaussian(half, radius / 2, np.ceil(1.5 * radius))
    x, y, *_ = grid(rgba)
    added = strength * sample(np.dstack([glow, np.zeros(half.shape[:2])]), x / 2, y / 2)[..., :3]
    shown = colour.cctf_encoding(np.minimum(added, 1), function='sRGB')
    opaque = alpha + (1 - alpha) * shown.max(axis=-1, keepdims=True)
    rgb = colour.cctf_encoding(np.minimum((light + added) / np.maximum(opaque, 1e-4), 1), function='sRGB')
    return premultiplied(rgb, opaque[..., 0])


# Names as in filters.test.ts
CASES = {
    'grey-full': lambda p: grey(p),
    'grey-part': lambda p: grey(p, 0.4),
    'luminance-variation-contrast': lambda p: luminance(p, 0, 1.4, 1),
    'luminance-variation-dark': lambda p: luminance(p, -0.2, 0.8, 1.7),
    'chrominance-variation-turned': lambda p: chrominance(p, 1, np.pi / 3, 0, 0),
    'chrominance-variation-shifted': lambda p: chrominance(p, 0.6, -1, 0.1, -0.2),
    'vignette-ellipse': lambda p: vignette(p),
    'vignette-circle': lambda p: vignette(p, 0.9, 0.2, 0.3, 1, (1, 0.9, 0.6)),
    'posterize-4': lambda p: posterize(p, 4),
    'posterize-7': lambda p: posterize(p, 7),
    'curves-contrast': lambda p: curves(p, [0, 0, 0.25, 0.1, 0.75, 0.9, 1, 1]),
    'curves-graded': lambda p: curves(
        p, [0.1, 0, 1, 0.9], [0, 0, 0.3, 0.6, 1, 1], [0, 0.1, 0.5, 0.4, 1, 1], [0, 0.3, 0.5, 0.5, 1, 0.8], [0, 0, 0.5, 0.65, 1, 1], 0.8),
    'chroma-key-green': lambda p: chroma_key(p),
    'chroma-key-red': lambda p: chroma_key(p, (0.8, 0.2, 0.1), 0.1, 0.2, 1),
    'skin-mask-soft': lambda p: skin(p, 4),
    'skin-mask-cut': lambda p: skin(p, 20, 3, True),
    'white-balance-warm': lambda p: white_balance(p, 3200, 9500, 0),
    'white-balance-between': lambda p: white_balance(p, 2500, 12000, 0.7),
    'hdr-exposure-long': lambda p: exposure(p, 1.5),
    'hdr-exposure-kept': lambda p: exposure(p, 2.5, 1),
    'hdr-exposure-short': lambda p: exposure(p, -2),
    'film-grain-gray': lambda p: film_grain(p, 0.08),
    'film-grain-color': lambda p: film_grain(p, 0.15, 3, 0.7, 1),
    'halftone-ink': lambda p: halftone(p, 8, np.pi / 4),
    'halftone-color': lambda p: halftone(p, 13.5, 0.3, True),
    'pixelate-8': lambda p: pixelate(p, 8),
    'pixelate-13': lambda p: pixelate(p, 13),
    'swirl-left': lambda p: swirl(p, 1.5, 60),
    'swirl-right': lambda p: swirl(p, -2, 200),
    'tile-plain': lambda p: tile(p, 4, 2),
    'tile-mirrored': lambda p: tile(p, 2, 8, True),
    'radial-blur-middle': lambda p: radial_blur(p, 0.2),
    'radial-blur-corner': lambda p: radial_blur(p, 0.3, (0.2, 0.9)),
    'spin-blur-middle': lambda p: spin_blur(p, 0.17453293),
    'spin-blur-corner': lambda p: spin_blur(p, 0.5, (0.2, 0.9)),
    'kuwahara-5': lambda p: kuwahara(p, 5, 8),
    'kuwahara-soft': lambda p: kuwahara(p, 3, 2),
    'anisotropic-kuwahara-6': lambda p: anisotropic_kuwahara(p, 6, 8),
    'anisotropic-kuwahara-round': lambda p: anisotropic_kuwahara(p, 4, 2, 0),
    'bilateral-6': lambda p: bilateral(p, 6, 0.2),
    'bilateral-wide': lambda p: bilateral(p, 10, 0.6),
    'difference-of-gaussians-ink': lambda p: dog_lines(p, 1, 20, 0.6, 4),
    'difference-of-gaussians-over': lambda p: dog_lines(p, 2.4, 40, 0.5, 10, True),
    'bloom-wide': lambda p: bloom(p, 0.5, 12, 1),
    'bloom-near': lambda p: bloom(p, 0.1, 3, 2),
}


def main():
    inputs = {'generated': read(os.path.join(HERE, 'generated.png')), 'astronaut': read(sys.argv[1])[:256, 128:384]}
    for case, apply in CASES.items():
        if not case.startswith(tuple(sys.argv[2:] or [''])):
            continue
        save(f'generated-{case}', apply(inputs['generated']))
        save(f'astronaut-{case}', apply(inputs['astronaut'])[7::8, 5::8])


if __name__ == '__main__':
    main()
