"""A triangle mesh that rays can be cast at: where a scan's surface lies."""
import math
from collections import defaultdict
from sculpt import add, cross, dot, sub, unit


class Scan:
    def __init__(self, path, bin_size):
        words = open(path).read().split()
        n, m = int(words[1]), int(words[2])
        c = list(map(float, words[4:4 + 3 * n]))
        self.points = list(zip(c[0::3], c[1::3], c[2::3]))
        self.triangles, i = [], 4 + 3 * n
        for _ in range(m):
            k = int(words[i])
            corners = list(map(int, words[i + 1:i + 1 + k]))
            self.triangles += [(corners[0], a, b) for a, b in zip(corners[1:], corners[2:])]
            i += 1 + k
        self.size, self.bins = bin_size, defaultdict(list)
        for t, corners in enumerate(self.triangles):
            p = [self.points[v] for v in corners]
            for key in self.keys([min(q[a] for q in p) for a in range(3)],
                                 [max(q[a] for q in p) for a in range(3)]):
                self.bins[key].append(t)

    def keys(self, low, high):
        a, b = [[math.floor(x / self.size) for x in p] for p in (low, high)]
        return [(i, j, k) for i in range(a[0], b[0] + 1) for j in range(a[1], b[1] + 1)
                for k in range(a[2], b[2] + 1)]

    def hit(self, t, origin, d):
        a, b, c = (self.points[v] for v in self.triangles[t])
        e, f = sub(b, a), sub(c, a)
        h = cross(d, f)
        det = dot(e, h)
        if abs(det) < 1e-18:
            return None
        s = sub(origin, a)
        u = dot(s, h) / det
        q = cross(s, e)
        v = dot(d, q) / det
        if u < 0 or v < 0 or u + v > 1:
            return None
        at = dot(f, q) / det
        return (at, unit(cross(e, f))) if at > 0 else None

    def cast(self, origin, direction, far=3.0):
        """(point, outward normal) of the first hit, or None."""
        d, step, seen, best = unit(direction), self.size / 2, set(), None
        for i in range(int(far / step)):
            p = add(origin, d, i * step)
            for key in self.keys(*[[x + s * step for x in p] for s in (-1, 1)]):
                if key not in seen:
                    seen.add(key)
                    for t in self.bins.get(key, ()):
                        found = self.hit(t, origin, d)
                        if found and (best is None or found[0] < best[0]):
                            best = found
            if best and best[0] <= i * step:
                break
        if best is None:
            return None
        n = best[1] if dot(best[1], d) < 0 else sub((0, 0, 0), best[1])
        return add(origin, d, best[0]), n

    def toward(self, centre, direction):
        return self.cast(add(centre, unit(direction), 1.5), sub((0, 0, 0), direction))

    def front(self, x, y):
        return self.cast((x, y, 1.0), (0, 0, -1))

    def front_line(self, points, lift=0.0):
        out = []
        for p in points:
            found = self.front(p[0], p[1])
            if found:
                out.append(add(found[0], found[1], lift) + tuple(p[2:]))
        return out
