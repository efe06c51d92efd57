function text = answer(arguments)
% ANSWER  Returns the output of the command for arguments (text, already quoted).
kept = [tempname() '.txt'];
try
    call([arguments ' >' quoted(kept)], false);
    text = fileread(kept);
catch problem
    if exist(kept, 'file')
        delete(kept);
    end
    rethrow(problem);
end
delete(kept);
end
