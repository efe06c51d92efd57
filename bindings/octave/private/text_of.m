function value = text_of(value)
% TEXT_OF  Converts a string object of MATLAB ("paper.yaml") to the characters 'paper.yaml'; other values are unchanged.
if isa(value, 'string') && numel(value) == 1
    value = char(value);
end
end
