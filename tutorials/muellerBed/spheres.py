"""spheres.py -- images of spheres in parallel projection: depth buffer, lighting, shadows, ambient
occlusion.

Every sphere is drawn pixel by pixel, and the nearest wins; its depth gives the normal. One lamp
casts shadows (a second depth buffer, seen from the lamp). The whole sky lights a pixel as far as
its neighbours leave it open (its depth against the depth around it, at several widths).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy


def axes(towards, up):
    """Right, up and back of a camera that looks along `towards`; rows of a matrix."""
    back = -numpy.asarray(towards, float)/numpy.linalg.norm(towards)
    right = numpy.cross(up, back)
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(back, right), back])


def stamp(seen, radii, scale, origin, shape):
    """Depth [m] towards the camera and index of the nearest sphere in each pixel; -inf and -1 where
    there is none."""
    depth = numpy.full(shape, -numpy.inf)
    owner = numpy.full(shape, -1, dtype=numpy.int32)
    for i, ((x, y, z), radius) in enumerate(zip(seen, radii)):
        reach = int(numpy.ceil(radius*scale)) + 1
        offset = numpy.arange(-reach, reach + 1)
        column, row = (x - origin[0])*scale, shape[0] - (y - origin[1])*scale
        c, r = int(column) + offset, int(row) + offset
        c, r = c[(c >= 0) & (c < shape[1])], r[(r >= 0) & (r < shape[0])]
        if c.size == 0 or r.size == 0:
            continue
        rest = radius**2 - (((c + 0.5 - column)/scale)**2)[None,
            :] - (((r + 0.5 - row)/scale)**2)[:, None]
        here = numpy.where(rest > 0, z + numpy.sqrt(numpy.maximum(rest, 0)), -numpy.inf)
        window = (slice(r[0], r[-1] + 1), slice(c[0], c[-1] + 1))
        nearer = here > depth[window]
        depth[window][nearer] = here[nearer]
        owner[window][nearer] = i
    return depth, owner


def blur(image, width):
    """Mean over a square of 2 width + 1 pixels, edges repeated."""
    for axis in (0, 1):
        pad = [(width + 1, width) if a == axis else (0, 0) for a in (0, 1)]
        total = numpy.cumsum(numpy.pad(image, pad, mode="edge"), axis=axis)
        n = image.shape[axis]
        image = (numpy.take(total, range(2*width + 1, 2*width + 1 + n), axis)
                 - numpy.take(total, range(n), axis))/(2*width + 1)
    return image


def openness(depth, radius, scale, floor):
    """Fraction of the sky visible from a pixel: less where surroundings are nearer to the
    camera."""
    ground = numpy.where(numpy.isfinite(depth), depth, floor)
    light = numpy.ones_like(ground)
    for width in (0.5, 1.0, 2.0, 4.0):
        near = blur(ground, max(1, int(width*radius*scale)))
        light -= 0.22*numpy.clip((near - ground)/(1.5*width*radius) + 0.05, 0, 1)
    return numpy.clip(light, 0.25, 1)


def in_shadow(points, spheres, radii, lamp, scale):
    """1 in the lamp's light, 0 in shadow, smoothed over a few samples of the lamp's depth
    buffer."""
    seen, radius = spheres @ lamp.T, radii.mean()
    origin = seen[:, :2].min(axis=0) - 2*radius
    extent = (seen[:, :2].max(axis=0) + 2*radius - origin)*scale
    shape = (int(extent[1]) + 1, int(extent[0]) + 1)
    depth, _ = stamp(seen, radii, scale, origin, shape)
    at = points @ lamp.T
    lit = numpy.zeros(len(points))
    taps = [(-1, 0), (1, 0), (0, -1), (0, 1), (0, 0)]
    for dx, dy in taps:
        c = numpy.clip(((at[:, 0] - origin[0])*scale + 1.5*dx).astype(int), 0, shape[1] - 1)
        r = numpy.clip((shape[0] - (at[:, 1] - origin[1])*scale + 1.5*dy).astype(int), 0,
                       shape[0] - 1)
        lit += depth[r, c] < at[:, 2] + 0.35*radius
    return lit/len(taps)


def draw(spheres, radii, colour, window, scale, towards=(0.18, 1, -0.16), up=(0, 0, 1), finer=2):
    """An image (rows, columns, 4) of spheres of these radii [m] with colours in 0 .. 1; `window` is
    (left, bottom, right, top) [m] on the camera's plane, `scale` in pixels per metre; transparent
    where there is nothing."""
    camera = axes(towards, up)
    seen = spheres @ camera.T
    fine = scale*finer
    shape = (int(round((window[3] - window[1])*scale))*finer,
             int(round((window[2] - window[0])*scale))*finer)
    depth, owner = stamp(seen, radii, fine, window[:2], shape)
    hit = owner >= 0

    rows, columns = numpy.nonzero(hit)
    place = numpy.stack([window[0] + (columns + 0.5)/fine, window[1] + (shape[0] - rows - 0.5)/fine,
                         depth[hit]], axis=1)
    normal = (place - seen[owner[hit]])/radii[owner[hit], None]
    lamp = axes((0.55, 0.75, -1.0), up)
    towards_lamp = camera @ lamp[2]                 # in the camera's axes
    lit = in_shadow(place @ camera, spheres, radii, lamp, fine)

    facing = numpy.clip(normal @ towards_lamp, 0, 1)
    halfway = towards_lamp + [0, 0, 1]
    gloss = numpy.clip(normal @ (halfway/numpy.linalg.norm(halfway)), 0, 1)**40
    sky = openness(depth, radii.mean(), fine, seen[:, 2].min())[hit]*(0.62 + 0.38*normal[:, 1])
    shade = 0.55*sky + 0.62*facing*lit
    image = numpy.zeros(shape + (4,))
    image[hit, :3] = numpy.clip(colour[owner[hit]]*shade[:, None] + 0.22*(gloss*lit)[:, None], 0, 1)
    image[hit, 3] = 1

    # mean over the finer pixels, weighted by their coverage
    image[..., :3] *= image[..., 3:]
    image = image.reshape(shape[0]//finer, finer, shape[1]//finer, finer, 4).mean(axis=(1, 3))
    image[..., :3] /= numpy.maximum(image[..., 3:], 1e-9)
    return image
