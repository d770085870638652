"""Writes plans as other programs do: Sweet Home 3D homes, Vadere scenarios, walkable areas (WKT)."""

import json
import math


def angle_of(a, b):
    return math.atan2(b[1] - a[1], b[0] - a[0])


def home(plan, put, joined=True, level=True):
    """Home.xml: centimetres, y down, angles in radians that turn clockwise. A door's sash is 90 % of its width."""
    centimetres = lambda at: (100 * put(at)[0], -100 * put(at)[1])
    storey = " level='l0'" if level else ""
    parts = ["<level id='l0' name='Ground floor' elevation='0.0' floorThickness='12.0' height='250.0'/>"] if level else []
    for a, b, thick in plan.axes if joined else plan.centre_lines():
        (x0, y0), (x1, y1) = centimetres(a), centimetres(b)
        parts.append(f"<wall id='w{len(parts)}'{storey} xStart='{x0!r}' yStart='{y0!r}' xEnd='{x1!r}' yEnd='{y1!r}' height='250.0' "
                     f"thickness='{100 * thick!r}' patternName='hatchUp'/>")
    for opening, hinge, shut, opened in plan.doors:
        x, y = centimetres(((opening[0] + opening[2]) / 2, (opening[1] + opening[3]) / 2))
        h, s, o = put(hinge), put(shut), put(opened)
        left = (s[0] - h[0]) * (o[1] - h[1]) - (s[1] - h[1]) * (o[0] - h[0]) > 0
        parts.append(f"<doorOrWindow{storey} catalogId='eTeks#door' name='Door' x='{x!r}' y='{y!r}' width='{100 * math.dist(h, s) / 0.9!r}' "
                     f"depth='12.0' height='208.5' angle='{-angle_of(h, s)!r}' movable='false' wallThickness='1.0'><sash xAxis='0.05' "
                     f"yAxis='0.5' width='0.9' startAngle='0.0' endAngle='{math.pi / 2 * (1 if left else -1)!r}'/></doorOrWindow>")
    for room in plan.rooms:
        points = "".join(f"<point x='{x!r}' y='{y!r}'/>" for x, y in map(centimetres, room))
        parts.append(f"<room id='r{len(parts)}'{storey} name='Room' areaVisible='true'>{points}</room>")
    return "<?xml version='1.0'?>\n<home version='7200' name='flat.sh3d' camera='topCamera'>\n" + "\n".join(parts) + "\n</home>\n"


def scenario(obstacles, bounds, turned=False, frame=0.5, people=0):
    """A scenario of Vadere 2.4: obstacles are polygons; upright ones become rectangles unless `turned`."""
    def shape(points):
        if turned:
            return {"type": "POLYGON", "points": [{"x": x, "y": y} for x, y in points]}
        (x0, y0), (x1, y1) = points[0], points[2]
        return {"x": x0, "y": y0, "width": x1 - x0, "height": y1 - y0, "type": "RECTANGLE"}

    x0, y0, x1, y1 = bounds
    topography = {"attributes": {"bounds": {"x": x0, "y": y0, "width": x1 - x0, "height": y1 - y0}, "boundingBoxWidth": frame,
                                 "bounded": frame > 0, "referenceCoordinateSystem": None},
                  "obstacles": [{"id": i + 1, "shape": shape(points), "visible": True} for i, points in enumerate(obstacles)],
                  "measurementAreas": [], "stairs": [], "targets": [], "sources": [],
                  "dynamicElements": [{"type": "PEDESTRIAN", "position": {"x": x0 + 1 + i, "y": y0 + 1}, "targetIds": []} for i in range(people)]}
    return json.dumps({"name": "rooms", "description": "", "release": "2.4",
                       "scenario": {"mainModel": "org.vadere.simulator.models.osm.OptimalStepsModel", "topography": topography}}, indent=2)


def area(*rings, put):
    return ", ".join("(" + ", ".join(f"{x!r} {y!r}" for x, y in map(put, ring + ring[:1])) + ")" for ring in rings)
