// Half a section through the round film of membrane.geo about the x3 axis: radius R and thickness h in
// mm, with an electrode of radius Re in its middle. n1 cells from the axis to the edge of the
// electrode, n2 from there to the frame, both wider by `coarser` from cell to cell away from the edge;
// n3 through the thickness. Regions: active (under the electrode), passive. Curves: bottom (x3 = 0),
// bottom_active, top_active, frame, axis. Point at x3 = 0: edge (the electrode's).
DefineConstant[
  R = {15, Name "R"}, Re = {5, Name "Re"}, h = {0.25, Name "h"}, coarser = {1.15, Name "coarser"},
  n1 = {8, Name "n1", Min 1, Max 5000, Step 1}, n2 = {8, Name "n2", Min 1, Max 5000, Step 1},
  n3 = {1, Name "n3", Min 1, Max 500, Step 1}
];
Point(1) = {0, 0, 0};
Point(2) = {Re, 0, 0};
Point(3) = {R, 0, 0};
Line(1) = {2, 1};
Line(2) = {2, 3};
Transfinite Curve {1} = n1 + 1 Using Progression coarser;
Transfinite Curve {2} = n2 + 1 Using Progression coarser;
active[] = Extrude {0, 0, h} { Line{1}; Layers{n3}; Recombine; };
passive[] = Extrude {0, 0, h} { Line{2}; Layers{n3}; Recombine; };
Physical Surface("active") = active[1];
Physical Surface("passive") = passive[1];
Physical Curve("bottom") = {1, 2};
Physical Curve("bottom_active") = 1;
Physical Curve("top_active") = active[0];
Physical Curve("axis") = active[2];
Physical Curve("frame") = passive[2];
Physical Point("edge") = 2;
