// What is cut out has a colour too; it counts only where there is nothing else.
const float CUT_OUT_WEIGHT = 0.0009765625;
