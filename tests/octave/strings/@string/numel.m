function count = numel(text, varargin)
% A string is one thing, however long.
count = 1;
end
