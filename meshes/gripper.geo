// Half of a gripper in the x1-x3 plane: a finger of two bonded layers of H/2 each, [0,H] x [0,L] in mm,
// on a palm [0,S] x [-T,0] that ends in the plane of symmetry x1 = S. Cells: n1 (even) x n3 in the
// finger, ns beside it and nt along the depth of the palm. Regions: active (x1 < H/2), passive, palm.
// Curves: outer (x1 = 0), interface (x1 = H/2), inner (x1 = H, towards the other finger), mount
// (x3 = -T), middle (x1 = S). Points: tip (x1 = H, x3 = L), outer_tip (x1 = 0).
DefineConstant[
  L = {20, Name "L"}, H = {1, Name "H"}, S = {8, Name "S"}, T = {2, Name "T"},
  n1 = {2, Name "n1"}, n3 = {20, Name "n3"}, ns = {7, Name "ns"}, nt = {2, Name "nt"}
];
Point(1) = {0, 0, 0};
lower[] = Extrude {H/2, 0, 0} { Point{1}; Layers{n1/2}; };
upper[] = Extrude {H/2, 0, 0} { Point{lower[0]}; Layers{n1/2}; };
beside[] = Extrude {S-H, 0, 0} { Point{upper[0]}; Layers{ns}; };
active[] = Extrude {0, 0, L} { Line{lower[1]}; Layers{n3}; Recombine; };
passive[] = Extrude {0, 0, L} { Line{upper[1]}; Layers{n3}; Recombine; };
palm_1[] = Extrude {0, 0, -T} { Line{lower[1]}; Layers{nt}; Recombine; };
palm_2[] = Extrude {0, 0, -T} { Line{upper[1]}; Layers{nt}; Recombine; };
palm_3[] = Extrude {0, 0, -T} { Line{beside[1]}; Layers{nt}; Recombine; };
e = H * 1e-6;
Physical Surface("active") = active[1];
Physical Surface("passive") = passive[1];
Physical Surface("palm") = {palm_1[1], palm_2[1], palm_3[1]};
Physical Curve("outer") = Curve In BoundingBox {-e, -e, -e, e, e, L+e};
Physical Curve("interface") = Curve In BoundingBox {H/2-e, -e, -e, H/2+e, e, L+e};
Physical Curve("inner") = Curve In BoundingBox {H-e, -e, -e, H+e, e, L+e};
Physical Curve("mount") = Curve In BoundingBox {-e, -e, -T-e, S+e, e, -T+e};
Physical Curve("middle") = Curve In BoundingBox {S-e, -e, -T-e, S+e, e, e};
Physical Point("tip") = Point In BoundingBox {H-e, -e, L-e, H+e, e, L+e};
Physical Point("outer_tip") = Point In BoundingBox {-e, -e, L-e, e, e, L+e};
