function label = length_label(result, what)
% LENGTH_LABEL  What an axis of lengths is called: 'x of disc (mm)', or 'x of disc / c' where they stand over a scale.
about = result.case_.attributes;
if about.shown_length_over
    label = [what ' / ' about.shown_length_unit];
else
    label = [what ' (' about.shown_length_unit ')'];
end
end
