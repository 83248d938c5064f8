// A quarter, x1 > 0 and x2 > 0, of a round film in a frame, radius R and thickness h in mm, with an
// electrode of radius Re in its middle. n cells along an eighth of a circle, nr from the square in the
// middle to the edge of the electrode, nR from there to the frame, n3 through the thickness; straight
// edges. Regions: active (under the electrode), passive. Surfaces: bottom (x3 = 0), top_active,
// bottom_active, frame, x1_min, x2_min. Points at x3 = 0: edge (the electrode's, on the x1 axis).
DefineConstant[
  R = {15, Name "R"}, Re = {5, Name "Re"}, h = {0.25, Name "h"},
  n = {4, Name "n", Min 1, Max 500, Step 1}, nr = {3, Name "nr", Min 1, Max 500, Step 1},
  nR = {8, Name "nR", Min 1, Max 500, Step 1}, n3 = {1, Name "n3", Min 1, Max 500, Step 1},
  coarser = {1.15, Name "coarser"}
];
a = 0.5 * Re;
b = 0.42 * Re;
c = Sqrt(0.5);
Point(1) = {0, 0, 0};
Point(2) = {a, 0, 0};
Point(3) = {b, b, 0};
Point(4) = {0, a, 0};
Point(5) = {Re, 0, 0};
Point(6) = {Re*c, Re*c, 0};
Point(7) = {0, Re, 0};
Point(8) = {R, 0, 0};
Point(9) = {R*c, R*c, 0};
Point(10) = {0, R, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Circle(5) = {5, 1, 6};
Circle(6) = {6, 1, 7};
Circle(7) = {8, 1, 9};
Circle(8) = {9, 1, 10};
Line(9) = {2, 5};
Line(10) = {3, 6};
Line(11) = {4, 7};
Line(12) = {5, 8};
Line(13) = {6, 9};
Line(14) = {7, 10};
Transfinite Curve {1:8} = n + 1;
Transfinite Curve {9:11} = nr + 1;
Transfinite Curve {12:14} = nR + 1 Using Progression coarser;
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {9, 5, -10, -2};
Curve Loop(3) = {10, 6, -11, -3};
Curve Loop(4) = {12, 7, -13, -5};
Curve Loop(5) = {13, 8, -14, -6};
For s In {1:5}
  Plane Surface(s) = {s};
EndFor
Transfinite Surface {1:5};
Recombine Surface {1:5};
tops[] = {};
bodies[] = {};
For s In {1:5}
  body[] = Extrude {0, 0, h} { Surface{s}; Layers{n3}; Recombine; };
  tops[] += body[0];
  bodies[] += body[1];
EndFor
e = h * 1e-6;
Physical Volume("active") = bodies[{0:2}];
Physical Volume("passive") = bodies[{3:4}];
Physical Surface("bottom") = {1:5};
Physical Surface("bottom_active") = {1:3};
Physical Surface("top_active") = tops[{0:2}];
Physical Surface("x1_min") = Surface In BoundingBox {-e, -e, -e, e, R+e, h+e};
Physical Surface("x2_min") = Surface In BoundingBox {-e, -e, -e, R+e, e, h+e};
Physical Surface("frame") = {Surface In BoundingBox {R*c-e, -e, -e, R+e, R*c+e, h+e},
                             Surface In BoundingBox {-e, R*c-e, -e, R*c+e, R+e, h+e}};
Physical Point("edge") = {5};
