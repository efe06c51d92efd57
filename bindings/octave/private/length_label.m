function label = length_label(result, what, counted)
% LENGTH_LABEL  What an axis of lengths is called: 'x of disc (mm)', or 'x of disc / c' where they stand over a scale.
%   COUNTED says how, '' of places: 'amplitude (mm p-p)', 'amplitude / c (p-p)'.
about = result.case_.attributes;
if nargin < 3
    counted = '';
end
if ~about.shown_length_over
    label = [what ' (' strtrim([about.shown_length_unit ' ' counted]) ')'];
elseif isempty(counted)
    label = [what ' / ' about.shown_length_unit];
else
    label = [what ' / ' about.shown_length_unit ' (' counted ')'];
end
end
