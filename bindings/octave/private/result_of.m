function result = result_of(result)
% RESULT_OF  A result: what whirl_read gave, or the name of its file.
result = text_of(result);
if ischar(result)
    result = whirl_read(result);
end
if ~isstruct(result) || ~isfield(result, 'attributes') || ~isfield(result.attributes, 'tables')
    error('whirl:badInput', 'expected a result: the name of a file, or what whirl_read gives');
end
if ~isfield(result, 'case_') || ~isfield(result.case_.attributes, 'shown_length')
    error('whirl:badInput', 'the result does not tell the units of figures: compute it again');
end
end
