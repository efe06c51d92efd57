function pad_values(axes_handle, values, limits)
% PAD_VALUES  Room beside the first and the last value of the parameter, so that their marks are whole; LIMITS is the
%   property of its axis, XLim without it.
if nargin < 3
    limits = 'XLim';
end
span = [min(values), max(values)];
if numel(span) < 2 || ~(span(1) < span(2))
    return
end
span = span + 0.02 * [-1, 1] * diff(span);
if strcmp(get(axes_handle, [limits 'Mode']), 'manual')
    % Axes that are held show what is there already, too.
    before = get(axes_handle, limits);
    span = [min(before(1), span(1)), max(before(2), span(2))];
end
set(axes_handle, limits, span);
end
