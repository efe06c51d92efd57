function found = document_of(name, file, what, folder, options)
% DOCUMENT_OF  Returns the JSON document that the command NAME prints for a file, decoded.
%   FILE is a file's name, or a struct of what it would say, which is written into FOLDER for that while, with its
%   version under the key NAME. WHAT names the kind of file in messages; OPTIONS follow it in the command.
if ~isstruct(file) && ~is_text(text_of(file))
    error('whirl:badInput', 'whirl_%s takes the name of %s, or a struct of what it would say', name, what);
end
if ~isstruct(file)
    found = jsondecode(answer([name ' ' quoted(file_of(text_of(file))) ' --json' options]));
    return
end
if ~isfield(file, name)
    file.(name) = 1;
end
kept = [tempname(folder) '.yaml'];
stream = fopen(kept, 'w');
if stream < 0
    error('whirl:failed', 'cannot write %s, expected a folder that may be written to', kept);
end
fwrite(stream, jsonencode(file));   % JSON is YAML
fclose(stream);
try
    found = jsondecode(answer([name ' ' quoted(kept) ' --json' options]));
catch problem
    delete(kept);
    rethrow(problem);
end
delete(kept);
end
