// The river dike with the river on its left: curves of their own where water stands. The ground is at y = 0.
DefineConstant[
  height   = {5.0, Name "Dike/height, m"},
  crest    = {4.0, Name "Dike/width of the crest, m"},
  slope    = {2.0, Name "Dike/run over rise of the slopes"},
  depth    = {6.0, Name "Ground/depth to rock, m"},
  margin   = {18.0, Name "Ground/width beside the dike, m"}
];
toe = crest / 2 + slope * height;
side = toe + margin;

Point(1) = {-side, -depth, 0};
Point(2) = {side, -depth, 0};
Point(3) = {side, 0, 0};
Point(4) = {toe, 0, 0};
Point(5) = {crest / 2, height, 0};
Point(6) = {-crest / 2, height, 0};
Point(7) = {-toe, 0, 0};
Point(8) = {-side, 0, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 1};
Line(9) = {7, 4};  // between ground and dike

Curve Loop(1) = {1, 2, 3, -9, 7, 8};
Plane Surface(1) = {1};
Curve Loop(2) = {9, 4, 5, 6};
Plane Surface(2) = {2};

Physical Surface("ground") = {1};
Physical Surface("dike") = {2};
Physical Curve("rock") = {1};
Physical Curve("sides") = {2, 8};
Physical Curve("river") = {6, 7};     // slope and bed
Physical Curve("land") = {3, 4, 5};   // ground, slope and crest
