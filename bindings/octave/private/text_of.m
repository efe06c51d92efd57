function value = text_of(value)
% TEXT_OF  A string object of MATLAB ("paper.yaml") as the characters of 'paper.yaml'; all else as it is.
if isa(value, 'string') && numel(value) == 1
    value = char(value);
end
end
