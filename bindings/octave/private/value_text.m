function text = value_text(result, name, value)
% VALUE_TEXT  A value of a parameter, given in SI, in words: 'omega = 600 rpm'.
[size_in_si, unit] = parameter_unit(result, name);
text = strtrim(sprintf('%s = %.6g %s', name, value / size_in_si, unit));
end
