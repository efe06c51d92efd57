function class = regime_classes(table)
% REGIME_CLASSES  The class of every point's verdict, as an index into the names of regimes.
FIELD = field_names();
code = field_of(table, FIELD.regime_code);
period = field_of(table, FIELD.regime_period);
class = 7 * ones(size(code));
class(code == 1) = 4;
class(code == 1 & period == 1) = 1;
class(code == 1 & period == 2) = 2;
class(code == 1 & period == 4) = 3;
class(code == 2) = 5;
class(code == 3) = 6;
class(code == 4) = 8;
end
