// One finger of a gripper in the x1-x3 plane, whose mirror image at x1 = 0 is the other: two bonded
// layers of H/2 each, [g,g+H] x [0,L] in mm, n1 (even) x n3 quadrilaterals. Regions: passive (inside,
// x1 < g+H/2), active. Curves: inner (x1 = g), interface, outer (x1 = g+H), palm (x3 = 0), x3_max.
// Points: pin (x1 = g+H/2, x3 = 0) and tip (x1 = g, x3 = L).
DefineConstant[
  L = {20, Name "L"}, H = {1, Name "H"}, g = {8, Name "g"},
  n1 = {2, Name "n1", Min 2, Max 500, Step 2}, n3 = {20, Name "n3", Min 1, Max 500, Step 1}
];
Point(1) = {g, 0, 0};
lower[] = Extrude {H/2, 0, 0} { Point{1}; Layers{n1/2}; };
upper[] = Extrude {H/2, 0, 0} { Point{lower[0]}; Layers{n1/2}; };
passive[] = Extrude {0, 0, L} { Line{lower[1]}; Layers{n3}; Recombine; };
active[] = Extrude {0, 0, L} { Line{upper[1]}; Layers{n3}; Recombine; };
e = H * 1e-6;
Physical Surface("passive") = passive[1];
Physical Surface("active") = active[1];
Physical Curve("inner") = Curve In BoundingBox {g-e, -e, -e, g+e, e, L+e};
Physical Curve("interface") = Curve In BoundingBox {g+H/2-e, -e, -e, g+H/2+e, e, L+e};
Physical Curve("outer") = Curve In BoundingBox {g+H-e, -e, -e, g+H+e, e, L+e};
Physical Curve("palm") = Curve In BoundingBox {g-e, -e, -e, g+H+e, e, e};
Physical Curve("x3_max") = Curve In BoundingBox {g-e, -e, L-e, g+H+e, e, L+e};
Physical Point("pin") = Point In BoundingBox {g+H/2-e, -e, -e, g+H/2+e, e, e};
Physical Point("tip") = Point In BoundingBox {g-e, -e, L-e, g+e, e, L+e};
