function text = point_title(subject, index)
% POINT_TITLE  The value of the parameter at a point, and its verdict: 'omega = 600 rpm: P-2'.
FIELD = field_names();
parameter = subject.table.attributes.parameter;
text = subject.name;
if ~isempty(parameter)
    values = flat(subject.table, subject.table.values);
    text = value_text(subject.result, parameter, values(index));
end
if has_field(subject.table, FIELD.regime_code)
    verdicts = flat(subject.table, subject.table.verdict.name);
    text = [text ': ' verdicts{index}];
end
end
