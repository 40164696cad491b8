#!/usr/bin/env python3
"""Write the demo's sea shell as a binary glTF 2.0 file.

    make_shell.py OUT.glb

Needs nothing but the Python 3 standard library, and always writes the same
shell.

The surface
-----------
A mollusc enlarges its shell only at the aperture and keeps the shape of that
aperture while it grows.  A closed "generating curve" C(s) that turns about an
axis while it grows by a constant factor per turn therefore sweeps out the
whole shell, and every point of the curve runs along a logarithmic spiral:

    P(theta, s) = exp(k theta) * R_y(theta) * (A + C(s)),    k = ln(W) / (2 pi)

where R_y turns about the shell's axis, A is the centre of the generating
curve in the half-plane through the axis, and W is the whorl expansion rate.
theta = 0 is the aperture here, and the apex lies at theta -> -infinity, in the
origin.  The sources:

    H. Moseley, "On the geometrical forms of turbinated and discoid shells",
        Phil. Trans. R. Soc. 128 (1838), 351-370: the logarithmic spiral.
    D. M. Raup, "Geometric analysis of shell coiling: general problems",
        J. Paleontology 40 (1966), 1178-1190: W, T (how fast the curve slides
        down the axis) and D (how far it stays from the axis).
    M. B. Cortie, "Models for mollusc shell shape", S. Afr. J. Sci. 85 (1989),
        454-460: elliptic generating curves and relief on the surface.
    C. A. Pickover, "A short recipe for seashell synthesis", IEEE Comp. Graph.
        Appl. 9(6) (1989), 8-11: the same surface as a graphics primitive.

Those describe a sheet without thickness.  A renderer that looks into the
aperture needs an outside, an inside and a lip, so the sheet here is folded:
it runs along the outside from the apex to the aperture, turns round the lip,
and runs back on the inside until it is out of sight.  One grid covers it all,
so there is no joint between the outside and the inside that could crack.
"""

import json
import math
import os
import struct
import sys
import tempfile

TAU = 2.0 * math.pi

# --- The coiling ------------------------------------------------------------
#
# All lengths are relative to the generating curve, which is about 1 in radius
# at the aperture; fit() scales the whole in the end.

WHORL_EXPANSION = 1.85   # Raup's W: a turn makes the tube 1.85 times as wide
GROWTH = math.log(WHORL_EXPANSION) / TAU
WHORLS = 5.5             # beyond that the tip is smaller than a pixel

# Centre of the generating curve at the aperture: its distance from the axis,
# and its height below the apex.  The distance is just more than the inner half
# of the curve, so that the tube winds round the axis without reaching it.  The
# drop lets each whorl sink well into the one before it, as in a living turban
# shell, whose animal builds no wall there but uses the old whorl's outside.
CENTRE_RADIUS = 0.98
CENTRE_DROP = 2.40

# --- The generating curve ---------------------------------------------------

HALF_WIDTH = 0.93
HALF_HEIGHT = 1.30       # a tall oval ...
LEAN = math.radians(8)   # ... whose foot leans outward

# The side of the curve that faces away from the rest of the shell.
OUTWARD = math.radians(-20)

# --- Wall, lip and flare ----------------------------------------------------

WALL = 0.070             # thickness of the wall
LIP_WALL = 0.060         # how much the wall thickens towards the lip ...
LIP_WALL_REACH = 0.22    # ... and within how many radians that dies away
FLARE = 0.50             # how far the lip opens beyond the tube ...
FLARE_REACH = 0.45       # ... and within how many radians that dies away
INSIDE_TURN = 0.8 * TAU  # how far back the inside goes: round the corner

# --- Relief -----------------------------------------------------------------

CORDS = 13               # spiral cords there would be on a full circle
CORD_HEIGHT = 0.024
CORD_REACH = 0.7         # radians from the lip over which they come up

# --- The mesh ---------------------------------------------------------------

# Fine enough for round silhouettes at a full screen, and below 65536 vertices.

COLUMNS = 88             # around the tube
ROWS_APEX = 4            # along it, piece by piece: see sheet_point()
ROWS_OUTSIDE = 160
ROWS_LIP = 10
ROWS_INSIDE = 36
ROWS_END = 4
CROWDING = 0.42          # 0: even rows and columns; towards 1: more where seen
SIZE = 2.0               # longest edge of the posed model's box

# The pose, in the order of its rotations about Y, X and Z: show the flank as
# well as the aperture, look a little onto the spire, and lean it back.
POSE_YAW = math.radians(-22)
POSE_PITCH = math.radians(14)
POSE_ROLL = math.radians(6)

DIFFERENCE = 3e-5        # step of the finite differences, see surface_frame()


# --- Small vectors ----------------------------------------------------------

def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(a, f):
    return (a[0] * f, a[1] * f, a[2] * f)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def unit(a):
    return mul(a, 1.0 / math.sqrt(dot(a, a)))


# --- The shell's surface ----------------------------------------------------

def generating_curve(s):
    """Point and outward unit normal of C(s), as (radial, up) pairs."""
    cos_s, sin_s = math.cos(s - LEAN), math.sin(s - LEAN)
    cos_l, sin_l = math.cos(LEAN), math.sin(LEAN)
    x, y = HALF_WIDTH * cos_s, HALF_HEIGHT * sin_s
    nx, ny = HALF_HEIGHT * cos_s, HALF_WIDTH * sin_s
    length = math.hypot(nx, ny)
    nx, ny = nx / length, ny / length
    return ((x * cos_l - y * sin_l, x * sin_l + y * cos_l),
            (nx * cos_l - ny * sin_l, nx * sin_l + ny * cos_l))


def exposure(s):
    """1 on the side of the tube that faces out, 0 on the side that faces in.

    Flare and relief are multiplied with a power of this: on the inner side a
    flaring or ribbed wall would break through the previous whorl, or cross
    the axis, where the sheet would fold over.
    """
    return 0.5 + 0.5 * math.cos(s - OUTWARD)


def flare(theta, s):
    """How far the aperture has opened, like the bell of a trumpet."""
    return FLARE * math.exp(theta / FLARE_REACH) * exposure(s) ** 1.5


def wall(theta):
    """Thickness of the wall, which grows into a bead at the lip."""
    return WALL + LIP_WALL * math.exp(theta / LIP_WALL_REACH)


def relief(theta, s):
    """Height of the cords, the ribs that run along the spiral."""
    calm = (1.0 - math.exp(min(theta, 0.0) / CORD_REACH)) ** 2
    return (CORD_HEIGHT * calm * exposure(s) ** 1.5
            * math.cos(CORDS * (s - OUTWARD)))


def growth_direction(theta):
    """Where the shell grows to: across the half-plane through the axis."""
    return (-math.sin(theta), 0.0, math.cos(theta))


def tube_point(theta, depth, s, girth=1.0, ahead=0.0):
    """P(theta, s), `depth` walls below the outside (0 outside, 1 inside).

    The caps of the tube shrink the generating curve about its centre to
    `girth`, and move it straight ahead.
    """
    (x, y), (nx, ny) = generating_curve(s)
    # Only the outside is ribbed: the nacre that lines a shell is smooth.
    outward = (flare(theta, s) - depth * wall(theta)
               + (1.0 - depth) * relief(theta, s))
    radial = CENTRE_RADIUS + girth * (x + outward * nx)
    up = -CENTRE_DROP + girth * (y + outward * ny)
    turned = (radial * math.cos(theta), up, radial * math.sin(theta))
    return mul(add(turned, mul(growth_direction(theta), ahead)),
               math.exp(GROWTH * theta))


def lip_point(depth, bulge, s):
    """A point on the lip: where the wall ends, moved on along the wall.

    It moves at right angles to the edge and within the wall's own surface.
    So the lip goes on smoothly from both sides of the wall, and is as round
    near the axis, where a turn hardly moves anything, as it is further out.
    """
    along = sub(tube_point(DIFFERENCE, depth, s),
                tube_point(-DIFFERENCE, depth, s))
    edge = unit(sub(tube_point(0.0, depth, s + DIFFERENCE),
                    tube_point(0.0, depth, s - DIFFERENCE)))
    forward = unit(sub(along, mul(edge, dot(along, edge))))
    return add(tube_point(0.0, depth, s),
               mul(forward, 0.5 * wall(0.0) * bulge))


# --- The path of the folded sheet -------------------------------------------
#
# A path parameter t in [0, 5] leads along the sheet; each unit is one of
#   0..1  a round cap that closes the apex
#   1..2  the outside, from the apex to the aperture
#   2..3  the lip, half a turn
#   3..4  the inside, back from the aperture
#   4..5  a round cap that closes the inside, out of sight

PATH_START, PATH_END = 0.0, 5.0
THETA_APEX = -WHORLS * TAU
THETA_INSIDE = -INSIDE_TURN


def sheet_point(t, s):
    """The point of the whole folded sheet at (t, s)."""
    piece = min(max(int(t), 0), 4)
    f = t - piece
    if piece == 0:
        angle = 0.5 * math.pi * f
        return tube_point(THETA_APEX, 0.0, s, math.sin(angle),
                          -HALF_WIDTH * math.cos(angle))
    if piece == 1:
        return tube_point(THETA_APEX * (1.0 - f), 0.0, s)
    if piece == 2:
        angle = math.pi * f
        return lip_point(0.5 - 0.5 * math.cos(angle), math.sin(angle), s)
    if piece == 3:
        return tube_point(THETA_INSIDE * f, 1.0, s)
    angle = 0.5 * math.pi * f
    return tube_point(THETA_INSIDE, 1.0, s, math.cos(angle),
                      -HALF_WIDTH * math.sin(angle))


def rows():
    """Path parameters of the grid's rows, from pole to pole."""
    out = [i / ROWS_APEX for i in range(ROWS_APEX + 1)]
    # Late whorls are large on screen and get more rows than early ones.
    for i in range(1, ROWS_OUTSIDE + 1):
        x = i / ROWS_OUTSIDE
        out.append(1.0 + x + CROWDING * x * (1.0 - x))
    out += [2.0 + i / ROWS_LIP for i in range(1, ROWS_LIP + 1)]
    # Likewise the part of the inside that the aperture shows.
    for i in range(1, ROWS_INSIDE + 1):
        x = i / ROWS_INSIDE
        out.append(3.0 + x - CROWDING * x * (1.0 - x))
    out += [4.0 + i / ROWS_END for i in range(1, ROWS_END + 1)]
    return out


def columns():
    """Angles s of the grid's columns, from seam to seam.

    The seam lies on the tube's inner side, where nobody looks; the columns
    crowd on its outer side, which carries the cords.
    """
    out = []
    for j in range(COLUMNS + 1):
        x = j / COLUMNS
        out.append(OUTWARD - math.pi + TAU * x + CROWDING * math.sin(TAU * x))
    return out


def surface_frame(t, s):
    """Position, normal and tangent of the sheet at (t, s).

    At the poles the cap's rows shrink to a point, where d/ds vanishes; the
    sheet there touches the half-plane through the axis.  Elsewhere the
    derivatives are central differences of the exact surface, which put the
    normal right to better than a thousandth of a radian.  The tangent follows
    t: along the growth of the shell on its outside, and back on its inside.
    The normal is (dP/ds) x (dP/dt), so it turns over at the lip as well: out
    of the shell on its outside, and into its hollow on its inside.
    """
    before = sheet_point(max(t - DIFFERENCE, PATH_START), s)
    after = sheet_point(min(t + DIFFERENCE, PATH_END), s)
    along = sub(after, before)
    if t == PATH_START:
        normal = mul(growth_direction(THETA_APEX), -1.0)
    elif t == PATH_END:
        normal = growth_direction(THETA_INSIDE)
    else:
        around = sub(sheet_point(t, s + DIFFERENCE),
                     sheet_point(t, s - DIFFERENCE))
        normal = unit(cross(around, along))
    tangent = unit(sub(along, mul(normal, dot(normal, along))))
    return sheet_point(t, s), normal, tangent


# --- The grid of triangles --------------------------------------------------

class Mesh:
    """One list per vertex attribute, and the triangles' indices."""

    def __init__(self):
        self.positions = []
        self.normals = []
        self.tangents = []
        self.uvs = []
        self.indices = []


def arc_lengths(ts, s):
    """Length of the path at s up to each t, as a fraction of the whole."""
    out = [0.0]
    for before, here in zip(ts, ts[1:]):
        step = sub(sheet_point(here, s), sheet_point(before, s))
        out.append(out[-1] + math.sqrt(dot(step, step)))
    return [length / out[-1] for length in out]


def build_mesh():
    mesh = Mesh()
    ts, angles = rows(), columns()
    us = arc_lengths(ts, OUTWARD)
    for t, u in zip(ts, us):
        frames = [surface_frame(t, s) for s in angles[:-1]]
        # The seam's second column repeats the first one bit for bit, with
        # only its v differing, so that neither a gap nor a crease shows.
        frames.append(frames[0])
        for j, (position, normal, tangent) in enumerate(frames):
            if unused(t, j):
                continue
            mesh.positions.append(position)
            mesh.normals.append(normal)
            # w = +1: u along the tangent and an image's up along
            # cross(normal, tangent), so v, which runs down, increases with s.
            mesh.tangents.append(tangent + (1.0,))
            mesh.uvs.append((u, j / COLUMNS))
    mesh.indices = grid_indices(len(ts) - 1)
    return mesh


def unused(t, j):
    """At a pole each cell has one triangle, so one vertex is left over."""
    return (t == PATH_START and j == COLUMNS) or (t == PATH_END and j == 0)


def grid_indices(last_row):
    """Two triangles for each cell of the grid, but one at the poles."""
    def vertex(i, j):
        return i * (COLUMNS + 1) + j - (i > 0) - (i == last_row)

    out = []
    for i in range(last_row):
        for j in range(COLUMNS):
            a, b = vertex(i, j), vertex(i, j + 1)
            c, d = vertex(i + 1, j), vertex(i + 1, j + 1)
            if i < last_row - 1:
                out += (a, d, c)
            if i > 0:
                out += (a, b, d)
    return out


# --- Pose -------------------------------------------------------------------

def quaternion(axis, angle):
    """Unit quaternion as (x, y, z, w), in glTF's order."""
    return mul(axis, math.sin(0.5 * angle)) + (math.cos(0.5 * angle),)


def quaternion_product(a, b):
    """The rotation that does b first and then a."""
    av, bv = a[:3], b[:3]
    vector = add(add(mul(bv, a[3]), mul(av, b[3])), cross(av, bv))
    return vector + (a[3] * b[3] - dot(av, bv),)


def rotate(q, v):
    twice = mul(cross(q[:3], v), 2.0)
    return add(add(v, mul(twice, q[3])), cross(q[:3], twice))


def pose_rotation():
    yaw = quaternion((0.0, 1.0, 0.0), POSE_YAW)
    pitch = quaternion((1.0, 0.0, 0.0), POSE_PITCH)
    roll = quaternion((0.0, 0.0, 1.0), POSE_ROLL)
    return quaternion_product(roll, quaternion_product(pitch, yaw))


def bounds(points):
    return (tuple(min(p[i] for p in points) for i in range(3)),
            tuple(max(p[i] for p in points) for i in range(3)))


def fit(positions, rotation):
    """Scale and centre the shell so that its posed box is SIZE at the origin.

    The result is still unposed: the rotation is left to the glTF node.
    """
    low, high = bounds([rotate(rotation, p) for p in positions])
    back = mul(rotation[:3], -1.0) + (rotation[3],)
    centre = rotate(back, mul(add(low, high), 0.5))
    scale = SIZE / max(sub(high, low))
    return [mul(sub(p, centre), scale) for p in positions]


# --- glTF -------------------------------------------------------------------

FLOAT, UNSIGNED_SHORT, UNSIGNED_INT = 5126, 5123, 5125
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963


def pack_floats(tuples):
    flat = [x for t in tuples for x in t]
    return struct.pack("<%df" % len(flat), *flat)


def pack_indices(indices, vertex_count):
    """Bytes and component type; 65535 is left out as it restarts a strip."""
    if vertex_count <= 65535:
        return struct.pack("<%dH" % len(indices), *indices), UNSIGNED_SHORT
    return struct.pack("<%dI" % len(indices), *indices), UNSIGNED_INT


def padded(data, fill):
    """Chunks of a binary glTF are a multiple of four bytes long."""
    return data + fill * (-len(data) % 4)


class Buffer:
    """The binary chunk, with one buffer view and one accessor per array."""

    def __init__(self):
        self.data = b""
        self.views = []
        self.accessors = []

    def append(self, data, target, component_type, kind, count, extra=None):
        self.views.append({"buffer": 0, "byteOffset": len(self.data),
                           "byteLength": len(data), "target": target})
        accessor = {"bufferView": len(self.views) - 1,
                    "componentType": component_type,
                    "count": count, "type": kind}
        accessor.update(extra or {})
        self.accessors.append(accessor)
        self.data = padded(self.data + data, b"\0")
        return len(self.accessors) - 1

    def append_vectors(self, tuples, with_bounds=False):
        data = pack_floats(tuples)
        kind = "VEC%d" % len(tuples[0])
        extra = {}
        if with_bounds:
            # As stored: the doubles may lie a little outside the floats.
            stored = list(struct.iter_unpack("<%df" % len(tuples[0]), data))
            low, high = bounds(stored)
            extra = {"min": list(low), "max": list(high)}
        return self.append(data, ARRAY_BUFFER, FLOAT, kind, len(tuples), extra)


def gltf(mesh, rotation):
    """The glTF document and its binary chunk."""
    buffer = Buffer()
    attributes = {
        "POSITION": buffer.append_vectors(mesh.positions, with_bounds=True),
        "NORMAL": buffer.append_vectors(mesh.normals),
        "TANGENT": buffer.append_vectors(mesh.tangents),
        "TEXCOORD_0": buffer.append_vectors(mesh.uvs),
    }
    data, component_type = pack_indices(mesh.indices, len(mesh.positions))
    indices = buffer.append(data, ELEMENT_ARRAY_BUFFER, component_type,
                            "SCALAR", len(mesh.indices))
    document = {
        "asset": {"version": "2.0", "generator": "nacre make_shell.py"},
        "scene": 0,
        "scenes": [{"name": "Shell", "nodes": [0]}],
        "nodes": [{"name": "Shell", "mesh": 0,
                   "rotation": [round(x, 7) for x in rotation]}],
        "meshes": [{"name": "Shell", "primitives": [
            {"attributes": attributes, "indices": indices, "material": 0}]}],
        "materials": [{
            "name": "Nacre",
            "doubleSided": True,
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.86, 0.82, 0.77, 1.0],
                "metallicFactor": 0.0,
                "roughnessFactor": 0.25,
            },
        }],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.data)}],
    }
    return document, buffer.data


def glb(document, binary):
    """The bytes of a binary glTF: header, JSON chunk, binary chunk."""
    text = padded(json.dumps(document, separators=(",", ":")).encode(), b" ")
    binary = padded(binary, b"\0")
    length = 12 + 8 + len(text) + 8 + len(binary)
    return (struct.pack("<4sII", b"glTF", 2, length)
            + struct.pack("<I4s", len(text), b"JSON") + text
            + struct.pack("<I4s", len(binary), b"BIN\0") + binary)


# --- Command line -----------------------------------------------------------

def check_writable(target):
    """Refuse what a rename would replace although it must not be written."""
    if os.path.isdir(target):
        raise OSError("is a directory")
    if os.path.exists(target) and not os.path.isfile(target):
        raise OSError("not a regular file")
    if os.path.exists(target) and not os.access(target, os.W_OK):
        raise OSError("permission denied")


def write_whole(name, data):
    """Write a file so that at no time half of it is there under its name."""
    target = os.path.realpath(name)
    check_writable(target)
    handle, part = tempfile.mkstemp(prefix=".shell-",
                                    dir=os.path.dirname(target))
    try:
        with os.fdopen(handle, "wb") as out:
            out.write(data)
        # mkstemp makes the file private; a model is as public as other files.
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(part, 0o666 & ~umask)
        os.replace(part, target)
    except BaseException:
        os.unlink(part)
        raise


def main(arguments):
    if len(arguments) != 2 or arguments[1][:1] in ("", "-"):
        print("usage: make_shell.py OUT.glb", file=sys.stderr)
        return 2
    rotation = pose_rotation()
    mesh = build_mesh()
    mesh.positions = fit(mesh.positions, rotation)
    try:
        write_whole(arguments[1], glb(*gltf(mesh, rotation)))
    except OSError as error:
        print("make_shell.py: cannot write %s: %s"
              % (arguments[1], error.strerror or error), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
