"""Times the steps of the ARPAS paper with OpenCV on one thread, on the room of panorama.bench.ts. Arguments: width, height, repeats.

Prints one number per repeat: milliseconds of CPU time for gray, maximum and mean, threshold, median, contours and moments.
"""
import sys
import time

import cv2
import numpy as np

width, height, repeats = map(int, sys.argv[1:])
cv2.setNumThreads(1)
u, v = np.meshgrid(np.arange(width) / width, np.arange(height) / height)
image = 60 + 40 * np.sin(7 * u) * np.cos(5 * v)
image[(u > 0.2) & (u < 0.25) & (v > 0.35) & (v < 0.45)] = 240
image[np.hypot((u - 0.6) * 2, v - 0.25) < 0.03] = 255
image = np.repeat(image.astype(np.uint8)[:, :, None], 3, axis=2)
for _ in range(repeats):
    start = time.process_time()
    gray = cv2.cvtColor(image, cv2.COLOR_RGB2GRAY)
    most, mean = int(gray.max()), float(gray.mean())
    _, bright = cv2.threshold(gray, 0.93 * most, 255, cv2.THRESH_BINARY)
    smooth = cv2.medianBlur(bright, 5)
    contours, _ = cv2.findContours(smooth, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    moments = [cv2.moments(contour) for contour in contours]
    print((time.process_time() - start) * 1000)
    assert most / mean >= 1.5 and len(moments) >= 1
