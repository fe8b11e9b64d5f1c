// The river dike in three lifts, each a surface of its own. The ground is at y = 0.
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
Point(4) = {-side, 0, 0};
For lift In {0:3}  // the ends of the joints, from the ground to the crest
  half = toe - slope * height * lift / 3;
  Point(10 + lift) = {-half, height * lift / 3, 0};
  Point(20 + lift) = {half, height * lift / 3, 0};
  Line(10 + lift) = {10 + lift, 20 + lift};
EndFor
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 20};
Line(4) = {10, 4};
Line(5) = {4, 1};
For lift In {1:3}
  Line(20 + lift) = {19 + lift, 20 + lift};
  Line(30 + lift) = {10 + lift, 9 + lift};
  Curve Loop(10 + lift) = {9 + lift, 20 + lift, -(10 + lift), 30 + lift};
  Plane Surface(10 + lift) = {10 + lift};
EndFor
Curve Loop(1) = {1, 2, 3, -10, 4, 5};
Plane Surface(1) = {1};

Physical Surface("ground") = {1};
Physical Surface("lift_1") = {11};
Physical Surface("lift_2") = {12};
Physical Surface("lift_3") = {13};
Physical Curve("rock") = {1};
Physical Curve("sides") = {2, 5};
Physical Curve("surface") = {3, 4};
Physical Curve("slopes") = {21, 22, 23, 31, 32, 33, 13};
