function kinds_legend(axes_handle, kinds, marker, varargin)
% KINDS_LEGEND  What the colours of kinds mean, with marks that are large enough to tell these.
%   KINDS_LEGEND(AXES, KINDS, MARKER, X, Y) lets it lie where no points are, as PLACE_LEGEND does; without X, Y outside.
marks = [];
for i = 1:numel(kinds.number)
    marks = [marks; draw_marks(axes_handle, NaN, NaN, marker, 6, kinds.colours(i, :))]; %#ok<AGROW>
end
place_legend(axes_handle, marks, kinds.names, varargin{:});
end
