function text = string(characters)
% STRING  Stands for MATLAB's string objects, which Octave has not: what "paper.yaml" is there.
text = class(struct('characters', characters), 'string');
end
